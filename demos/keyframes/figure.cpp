// What the figures of keyframes share: panes, units and words.
#include <algorithm>
#include <cmath>

#include "figure.h"
#include "mv/gl/word_size.h"
#include "mv/motion/nodes.h"

namespace mv::keyframes {

double unit(const Pane& pane) { return std::min(pane.width, pane.height) / 560.0; }
double metre(const Pane& pane) { return std::min(pane.width, pane.height) / 12.5; }
TextStyle wordStyle(const FrameInfo& frame, const vec4& color) {
    return {.height = std::clamp(frame.height() / 33, leastWords, 20), .color = color, .background = vec4(0)};
}

Pane wholePane(const FrameInfo& frame) { return {0, 0, frame.width(), frame.height()}; }
Box boxOf(const FrameInfo& frame, Part part) {
    const double room = std::min(64.0, frame.width() / 12.0), half = frame.height() / 2.0;
    if (frame.isUpright()) {  // below the scene: upper is left, lower is right
        const double middle = frame.width() / 2.0, below = leftPane(frame).y;
        return {{(part == Part::lower ? middle : 0) + room, std::min(48.0, below / 4)},
                {(part == Part::upper ? middle : 2 * middle) - room / 4, below - std::min(40.0, below / 4)}};
    }
    const double low = part == Part::upper ? half : 0, high = part == Part::lower ? half : 2 * half;
    return {{leftPane(frame).width + room, low + std::min(48.0, half / 4)},
            {frame.width() - room / 4, high - std::min(40.0, half / 4)}};
}
void words(Drawing& drawing, const FrameInfo& frame, int line, const std::string& text, const vec4& color) {
    const TextStyle style = wordStyle(frame, color);
    drawing.in(wholePane(frame));
    drawing.text({10, frame.height() - 6 - line * (style.height + 4)}, text, style);
}

Pane leftPane(const FrameInfo& frame) {
    const int high = std::max(frame.height() * 7 / 12, 1);
    if (frame.isUpright()) return {0, frame.height() - high, frame.width(), high};
    return {0, 0, std::max(frame.width() * 7 / 12, 1), frame.height()};
}
vec2 pixelOf(const Pane& pane, const vec2& place) {
    return vec2(pane.width, pane.height) / 2.0 + metre(pane) * (place - vec2(5, 5));
}
// Warn of curves that are not what they seem.
void tell(const Settings& s, const Frame& frame) {
    if (s.curve.startsAtOnce()) frame.say("the root leaves each key at infinite speed, which the graph cuts off");
    const auto warning = swingWarning(timesOf(s.keys.size()));
    if (warning && s.curve.kind == KeyCurve::Kind::lagrange) frame.say(*warning);
}

}  // namespace mv::keyframes
