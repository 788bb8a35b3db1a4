// The readouts of projections.
#include <algorithm>
#include <cmath>
#include <optional>

#include "mv/math/projection.h"
#include "projections.h"

namespace mv::projections {

// In a parallel view the images of the axes' directions have w = 0, and x and y say which way and how far a metre goes in the
// picture.
Axes measuredAxes(const View& view, const Pane& pane) {
    const mat4 clip = clipFromWorld(view, pane);
    const double metre = pane.height / (2 * halfShown(view, pane.aspect()));  // px
    Axes axes{};
    for (int axis = 0; axis < 3; ++axis) {
        const vec2 drawn = vec2(clip[axis]) * vec2(pane.width, pane.height) / 2.0;
        axes.drawn.at(std::size_t(axis)) = drawn;
        axes.length[axis] = std::hypot(drawn.x, drawn.y) / metre;
    }
    return axes;
}

Meeting meetingIn(const View& view, const Pane& pane) {
    const mat4 clip = clipFromWorld(view, pane);
    const std::array<vec3, 8> corners = wallCorners();
    Meeting meeting;
    for (int axis = 0; axis < 3; ++axis) {
        vec3 direction(0);
        direction[axis] = 1;
        const auto point = vanishingPoint(clip, direction, pane.width, pane.height);
        if (!point) continue;
        ++meeting.points;
        for (std::size_t i = 0; i < 8; ++i) {
            const std::array<vec3, 2> edge{corners.at(i), corners.at(i ^ std::size_t(1) << axis)};
            meeting.miss = std::max(meeting.miss, missOfVanishingPoint(*point, edge, clip, pane.width, pane.height));
        }
    }
    return meeting;
}

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    std::optional<double> off, miss;
    const FourViews four = views(s);
    for (std::size_t i = 0; i < 4; ++i) {
        const View& view = four.at(i);
        const Pane pane = frame.panes(4)[i];
        const bool isYours = view.name == "yours" || view.name == "perspective";
        if (view.isParallel()) {
            const vec3 length = measuredAxes(view, pane).length;
            for (int axis = 0; axis < 3; ++axis)
                off = std::max(off.value_or(0), std::abs(length[axis] - view.shortening[axis]));
            if (!isYours) continue;
            numbers.set("shortening-x", length.x);
            numbers.set("shortening-y", length.y);
            numbers.set("shortening-z", length.z);
        } else {
            const Meeting meeting = meetingIn(view, pane);
            miss = std::max(miss.value_or(0), meeting.miss);
            if (isYours) numbers.set("vanishing-points", meeting.points);
        }
    }
    if (off) numbers.set("shortening-error", *off);
    if (miss) numbers.set("meeting-error", *miss);
}

}  // namespace mv::projections
