// The figures of the dolly zoom: the size of the subject and the angle of view over time.
#include <array>
#include <string>
#include <vector>

#include "figure.h"
#include "mv/formatted.h"

namespace mv::keyframes {
namespace {

// With keys of its own red, computed blue; the wider one is shown.
void drawOverTime(Drawing& drawing, const Settings& s, double now, const FrameInfo& frame, Part part,
                  const std::string& name, double (*size)(const View&)) {
    std::array<std::vector<vec2>, 2> lines;
    double highest = 0;
    for (const Zoom zoomedBy : {Zoom::separate, Zoom::computed}) {
        auto& line = lines.at(std::size_t(zoomedBy));
        for (int i = 0; i <= 120; ++i) {
            line.emplace_back(i * lap / 120, size(viewAt(s.camera, s.curve, i * lap / 120, zoomedBy)));
            highest = std::max(highest, line.back().y);
        }
    }
    const Plot plot{
        boxOf(frame, part), {0, lap, "s; red: angle with keys of its own, blue: computed"}, {0, 1.15 * highest, name}};
    const Zoom zoom = s.camera.zoom;
    drawing.in(wholePane(frame));
    for (const double key : {0.0, lap / 2, lap})
        drawing.line(plot.pixel({key, 0}), plot.pixel({key, plot.y.high}), {grey, 1});
    drawing.curve(plot, lines[0], {red, zoom == Zoom::separate ? 3.5 : 1.5});
    drawing.curve(plot, lines[1], {blue, zoom == Zoom::computed ? 3.5 : 1.5});
    drawing.line(plot.pixel({now, 0}), plot.pixel({now, plot.y.high}), {orange, 1.5});
    drawing.axes(plot);
}

}  // namespace

// How large the subject is at the first key, and is to stay; then its size and the angle over time.
void showZoom(Drawing& drawing, const Settings& s, double now, const FrameInfo& frame) {
    const Zoom zoom = s.camera.zoom;
    const View first = viewAt(s.camera, s.curve, 0, zoom), view = viewAt(s.camera, s.curve, now, zoom);
    const Pane pane = leftPane(frame);
    const double half = first.sizeOf(figureHeight) * pane.height / 2;
    drawing.in(pane);
    for (const double y : {pane.height / 2.0 - half, pane.height / 2.0 + half})
        drawing.line({0, y}, {double(pane.width), y}, {ink, 1});
    const std::string angle = formatted(", angle of view %.1f deg", view.fovy);
    words(drawing, frame, 0, formatted("distance %.1f m", view.distance) + angle);
    drawOverTime(drawing, s, now, frame, Part::upper, "subject, part of the picture's height",
                 [](const View& v) { return v.sizeOf(figureHeight); });
    drawOverTime(drawing, s, now, frame, Part::lower, "angle of view, deg", [](const View& v) { return v.fovy; });
}

}  // namespace mv::keyframes
