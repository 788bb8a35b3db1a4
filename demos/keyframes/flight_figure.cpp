// The figures of a flight: the edge of the picture, and each property of the camera over time.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "figure.h"
#include "mv/formatted.h"

namespace mv::keyframes {

// The edge of the camera's picture, and each of its properties over time, as a number between its least and its largest.
void showFlight(Drawing& drawing, const Settings& s, double now, const Pane& seen, const FrameInfo& frame) {
    drawing.in(seen);
    const double right = seen.width, top = seen.height;
    drawing.line(std::array{vec2(0, 0), vec2(right, 0), vec2(right, top), vec2(0, top), vec2(0, 0)}, {ink, 2});
    struct Row {
        std::string name;
        double (*number)(const CameraAt&);
    };
    static const std::array<Row, 5> rows{{
        {"eye: m from its first key", [](const CameraAt& c) { return glm::distance(c.eye, cameraKeys()[0].eye); }},
        {"center: m from its first key",
         [](const CameraAt& c) { return glm::distance(c.center, cameraKeys()[0].center); }},
        {"up: deg from the vertical",
         [](const CameraAt& c) { return degrees(std::acos(std::clamp(glm::normalize(c.up).y, -1.0, 1.0))); }},
        {"aspect: width by height", [](const CameraAt& c) { return c.aspect; }},
        {"fovy: deg", [](const CameraAt& c) { return c.fovy; }},
    }};
    const Box whole = boxOf(frame, Part::both);
    const double rowHeight = (whole.high.y - whole.low.y) / double(rows.size());
    drawing.in(wholePane(frame));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<vec2> line;
        for (int k = 0; k <= 120; ++k) line.emplace_back(k * lap / 120, rows.at(i).number(cameraAt(s, k * lap / 120)));
        const auto byHeight = [](const vec2& a, const vec2& b) { return a.y < b.y; };
        const double low = std::min_element(line.begin(), line.end(), byHeight)->y,
                     high = std::max(std::max_element(line.begin(), line.end(), byHeight)->y, low + 1e-6);
        const double bottom = whole.high.y - rowHeight * double(i + 1);
        const Plot plot{{{whole.low.x, bottom + 0.12 * rowHeight}, {whole.high.x, bottom + 0.62 * rowHeight}},
                        {0, lap, ""},
                        {low, high, ""}};
        for (const double key : {0.0, 2.0, 4.0, lap}) {
            drawing.line(plot.pixel({key, low}), plot.pixel({key, high}), {grey, 1});
            if (i + 1 == rows.size())
                drawing.textAround(plot.pixel({key, low}) - vec2(0, 0.25 * rowHeight), formatted("%.0f s", key),
                                   wordStyle(frame, ink));
        }
        drawing.curve(plot, line, {blue, 2});
        const double value = rows.at(i).number(cameraAt(s, now));
        drawing.point(plot.pixel({now, value}), 9, orange);
        drawing.text({whole.low.x, bottom + 0.95 * rowHeight}, rows.at(i).name + formatted(": %.2f", value),
                     wordStyle(frame, ink));
    }
    words(drawing, frame, 0, nameOf(s.curve.kind) + ": keys at 0, 2, 4 and 6 s");
}

}  // namespace mv::keyframes
