#include "mv/run/compare.h"

#include <algorithm>
#include <cstdio>

#include "mv/gl/text.h"
#include "mv/image/compare.h"

namespace mv {

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
    char label[96];
    std::snprintf(label, sizeof label, "difference: %.2f %% of pixels, at most %.0f of 255", 100 * difference.fraction,
                  difference.maximum);
    labels.emplace_back(label);

    const int width = pictures[0].width, height = pictures[0].height, gap = 4;
    TextStyle style;
    style.background = {1, 1, 1, 1};
    // A narrow picture gets smaller words rather than words cut off.
    for (const std::string& text : labels) {
        while (style.height > 8 && textWidth(text, style) > width) --style.height;
    }
    const int strip = style.height + 8;
    const Target sheet(3 * width + 2 * gap, strip + height, {}, "comparison");
    FrameNotes notes;
    const Frame frame(index, sheet.width(), sheet.height(), notes);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 3; ++i) {
        const int x = i * (width + gap);
        showImage(frame, x, strip, pictures[static_cast<std::size_t>(i)]);
        drawText(frame, x, 0, labels[static_cast<std::size_t>(i)], style);
    }
    return sheet.read();
}

}  // namespace mv
