#include "shared/strip.h"
#include "mv/gl/word_size.h"

#include <algorithm>
#include <cmath>

#include "mv/error.h"

namespace mv {

namespace {

int textSize(const FrameInfo& frame) { return std::max(leastWords, std::min(frame.width() / 60, frame.height() / 35)); }

// As small as it takes to end before `right`, down to 6 px; words that do not then either are left out.
void drawAt(Drawing& drawing, const FrameInfo& frame, vec2 at, double right, const ColoredWords& words) {
    TextStyle style{textSize(frame), vec4(0), vec4(1, 1, 1, 0.6)};
    const auto end = [&] {
        double x = at.x;
        for (const auto& [text, color] : words) x += textWidth(text, style) + 4;
        return x;
    };
    while (style.height > 6 && end() > right) --style.height;
    for (const auto& [text, color] : words) {
        style.color = color;
        const double next = at.x + textWidth(text, style) + 4;
        if (next > right) break;
        drawing.text(at, text, style);
        at.x = next;
    }
}

}  // namespace

Pane paneAboveStrip(const FrameInfo& frame, double from, double to) {
    const int low = frame.height() * 3 / 10, left = static_cast<int>(from * frame.width());
    return {left, low, std::max(1, static_cast<int>(to * frame.width()) - left), frame.height() - low};
}

Box graphInStrip(const FrameInfo& frame, double from, double to) {
    const double w = frame.width(), low = std::min(46.0, 0.1 * frame.height());
    return {{from * w + std::min(64.0, w / 8), low}, {to * w - w / 60, 0.26 * frame.height()}};
}

double roundAbove(double value) {
    if (!(value > 0)) throw Error("roundAbove", "must be above 0", numberText(value));
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (value <= factor * power) return factor * power;
    }
    return 10 * power;
}

void drawWords(Drawing& drawing, const FrameInfo& frame, const Pane& pane, int line, const ColoredWords& words) {
    const double each = 1.6 * textSize(frame);
    drawAt(drawing, frame, {6, line < 0 ? -line * each : pane.height - 6 - line * each}, pane.width, words);
}

void drawAxes(Drawing& drawing, const FrameInfo& frame, const Plot& plot, const ColoredWords& title) {
    drawing.axes(plot);
    drawAt(drawing, frame, {plot.box.low.x, plot.box.high.y + 1.4 * textSize(frame)},
           plot.box.high.x + frame.width() / 60.0, title);
}

}  // namespace mv
