#include "clip_figure.h"
#include "mv/gl/word_size.h"

#include <algorithm>
#include <cstddef>

namespace mv {

using namespace clip;

Pane ClipFigure::leftPane(const FrameInfo& frame) {
    if (!frame.isUpright()) return {0, 0, std::max(1, frame.width() * 5 / 8), frame.height()};
    const int below = frame.height() * 3 / 8;
    return {0, below, frame.width(), frame.height() - below};
}

Plot ClipFigure::plotIn(const Pane& pane) {
    const double unit = std::min(pane.width / 6.2, pane.height / 5.8);
    const vec2 middle(pane.width / 2.0, pane.height / 2.0), half = unit / 2 * plane.size();
    return {{middle - half, middle + half}, {plane.low.x, plane.high.x}, {plane.low.y, plane.high.y}};
}

void ClipFigure::begin(const Frame& frame) {
    drawing.begin(frame);
    drawing.in(leftPane(frame));
    plot_ = plotIn(leftPane(frame));
    said_.clear();
}

void ClipFigure::draw(const Frame& frame) {
    drawing.in({0, 0, frame.width(), frame.height()});
    const int height = std::clamp(frame.height() / 32, leastWords, 18);
    vec2 at =
        frame.isUpright() ? vec2(12, leftPane(frame).y - 4) : vec2(leftPane(frame).width + 4, frame.height() - 12);
    for (const auto& [line, color] : said_) {
        if (!line.empty()) drawing.text(at, line, {height, color, vec4(0)});
        at.y -= 1.45 * height;
    }
    drawing.draw(frame);
}

void ClipFigure::outline(std::vector<vec2> corners, const Stroke& style) {
    if (corners.empty()) return;
    corners.push_back(corners.front());
    for (vec2& corner : corners) corner = px(corner);
    drawing.line(corners, style);
}

void ClipFigure::hatch(const std::vector<vec2>& corners, const vec4& color) {
    constexpr int lines = 56;
    for (int line = 0; line < lines; ++line) {
        const double y = plane.low.y + (line + 0.33) / lines * plane.size().y;
        std::vector<double> crossings;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 1; i < crossings.size(); i += 2)
            stroke({crossings[i - 1], y}, {crossings[i], y}, {color, 1});
    }
}

int ClipFigure::lineHeight(double of) const { return std::max(leastWords, static_cast<int>(plot_.box.size().y / of)); }

void ClipFigure::name(const vec2& at, const std::string& words, const vec4& color) {
    const int height = lineHeight(32);
    drawing.text(px(at) + vec2(8, height + 10), words, {height, color, vec4(1, 1, 1, 0.75)});
}

void ClipFigure::window(const Box& box) {
    drawing.fill({px(box.low), px(box.high)}, shade);
    for (const double x : {box.low.x, box.high.x}) stroke({x, plane.low.y}, {x, plane.high.y}, {grey, 1});
    for (const double y : {box.low.y, box.high.y}) stroke({plane.low.x, y}, {plane.high.x, y}, {grey, 1});
    outline({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, {ink, 2});
}

void ClipFigure::codes(const Box& box) {
    // In a corner of each region, where a segment seldom is
    const auto places = [&](int axis) {
        const double low = box.low[axis], high = box.high[axis], end = plane.high[axis];
        return std::array<double, 3>{
            plane.low[axis] + 0.3,
            axis == 0 ? high - 0.3 * std::min(1.0, high - low) : low + 0.3 * std::min(1.0, high - low),
            end - 0.3 * std::min(1.0, end - high)};
    };
    for (const double x : places(0)) {
        for (const double y : places(1))
            drawing.textAround(px({x, y}), codeText(regionCode(box, {x, y})), {lineHeight(26), grey, vec4(0)});
    }
}

}  // namespace mv
