#include "mv/show/compare.h"

#include <algorithm>
#include <cmath>
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

namespace {

struct Labelled {
    Picture picture;
    std::string label;
};

// So many beside each other, and the others below.
Picture sheetOf(const Stage& stage, int index, const std::vector<Labelled>& all, int across) {
    const int width = all.front().picture.width, height = all.front().picture.height;
    std::vector<std::string> labels;
    labels.reserve(all.size());
    for (const Labelled& each : all) labels.push_back(each.label);
    const TextStyle style = fittedStyle(labels, width, labelStyle(stage, index, {.background = {1, 1, 1, 1}}));
    const int strip = style.height + labelSpace, down = static_cast<int>(all.size()) / across;
    const Target sheet(across * width + (across - 1) * gap, down * (strip + height) + (down - 1) * gap, {},
                       "comparison");
    const FrameInfo frame(index, sheet.width(), sheet.height());
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const int x = static_cast<int>(i) % across * (width + gap);
        const int y = static_cast<int>(i) / across * (strip + height + gap);
        showImage(frame, x, y + strip, all[i].picture);
        drawText(frame, x, y, all[i].label, style);
    }
    return sheet.read();
}

}  // namespace

Picture compareSettings(Stage& stage, int index, const std::string& knob, const std::vector<std::string>& values) {
    std::vector<Labelled> all;
    for (const std::string& value : values) {
        stage.demo().knob(knob).parse(value);
        stage.draw(index);
        all.push_back({stage.picture(), std::string(knob).append(" = ").append(value)});
    }
    const Difference difference = compare(all[0].picture, all[1].picture);
    all.push_back({differencePicture(all[0].picture, all[1].picture), differenceText(difference)});
    return sheetOf(stage, index, all, 3);
}

Picture stripOf(Stage& stage, int index, const std::vector<KnobValues>& strip) {
    const std::size_t across = strip[0].values.size(), down = strip.size() > 1 ? strip[1].values.size() : 1;
    const int largest = largestTargetSide(), labelHeight = labelStyle(stage, index).height + labelSpace;
    const auto least = [&](std::size_t count, int side) { return static_cast<long>(count) * (side + gap); };
    if (least(across, stage.front().width()) > largest || least(down, stage.front().height() + labelHeight) > largest) {
        throw Error("--strip", "must fit into " + std::to_string(largest) + " pixels a side; --size makes each smaller",
                    std::to_string(across) + " x " + std::to_string(down) + " pictures");
    }
    std::vector<Labelled> all;
    for (std::size_t row = 0; row < down; ++row) {
        for (const std::string& value : strip[0].values) {
            std::string label = strip[0].knob + " = " + value;
            if (strip.size() > 1) label += ", " + strip[1].knob + " = " + strip[1].values[row];
            try {
                if (strip.size() > 1) stage.demo().knob(strip[1].knob).parse(strip[1].values[row]);
                stage.demo().knob(strip[0].knob).parse(value);
                stage.draw(index);
            } catch (const Error& error) {
                throw Error("with " + label, error.what());
            }
            all.push_back({stage.picture(), label});
        }
    }
    return sheetOf(stage, index, all, static_cast<int>(across));
}

std::string differenceText(const Difference& difference) {
    char text[96];
    std::snprintf(text, sizeof text, "difference: %.2f %% of pixels, at most %.0f of 255", 100 * difference.fraction,
                  difference.maximum);
    return text;
}

TextStyle labelStyle(const Stage& stage, int index, TextStyle style) {
    style.height = int(std::lround(style.height * stage.frame(index).inUnits().sizeScale()));
    return style;
}

TextStyle fittedStyle(const std::vector<std::string>& lines, int width, TextStyle style) {
    for (const std::string& line : lines) {
        while (style.height > 8 && textWidth(line, style) > width) --style.height;
    }
    return style;
}

}  // namespace mv
