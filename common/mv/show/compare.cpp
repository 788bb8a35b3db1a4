#include "mv/show/compare.h"

#include <algorithm>
#include <cstdio>

#include "mv/error.h"
#include "mv/gl/target.h"

namespace mv {
namespace {

constexpr int gap = 4;         // between the pictures
constexpr int labelSpace = 8;  // round a label's letters

}  // namespace

void requireRoomToCompare(int width, int height) {
    const int largest = largestTargetSide();
    const int widest = (largest - 2 * gap) / 3, highest = largest - TextStyle{}.height - labelSpace;
    if (width <= widest && height <= highest) return;
    throw Error("--compare",
                "lays three pictures beside each other; each must be at most " + std::to_string(widest) + "x" +
                    std::to_string(highest) + " on this driver, by --size",
                std::to_string(width) + "x" + std::to_string(height));
}

Picture compareSettings(Stage& stage, int index, const std::string& knob, const std::vector<std::string>& values) {
    std::vector<Picture> pictures;
    std::vector<std::string> labels;
    for (const std::string& value : values) {
        stage.demo().knob(knob).parse(value);
        stage.draw(index);
        pictures.push_back(stage.picture());
        labels.push_back(std::string(knob).append(" = ").append(value));
    }
    const Difference difference = compare(pictures[0], pictures[1]);
    pictures.push_back(differencePicture(pictures[0], pictures[1]));
    labels.push_back(differenceText(difference));

    const int width = pictures[0].width, height = pictures[0].height;
    const TextStyle style = fittedStyle(labels, width, {.background = {1, 1, 1, 1}});
    const int strip = style.height + labelSpace;
    const Target sheet(3 * width + 2 * gap, strip + height, {}, "comparison");
    const FrameInfo frame(index, sheet.width(), sheet.height());
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 3; ++i) {
        const int x = i * (width + gap);
        showImage(frame, x, strip, pictures[static_cast<std::size_t>(i)]);
        drawText(frame, x, 0, labels[static_cast<std::size_t>(i)], style);
    }
    return sheet.read();
}

std::string differenceText(const Difference& difference) {
    char text[96];
    std::snprintf(text, sizeof text, "difference: %.2f %% of pixels, at most %.0f of 255", 100 * difference.fraction,
                  difference.maximum);
    return text;
}

TextStyle fittedStyle(const std::vector<std::string>& lines, int width, TextStyle style) {
    for (const std::string& line : lines) {
        while (style.height > 8 && textWidth(line, style) > width) --style.height;
    }
    return style;
}

}  // namespace mv
