// The names of the panes of projections, the axes with their shortenings, and the vanishing points.
#include <algorithm>
#include <cmath>
#include <string>

#include "mv/formatted.h"
#include "mv/gl/functions.h"
#include "mv/gl/text.h"
#include "mv/math/projection.h"
#include "projections.h"

namespace mv::projections {

static const std::array<std::string, 3> axisNames{"x", "y", "z"};

// Draw the axes at a corner of the walls, 2 m long, and write how long one metre of each is drawn.
static void drawAxes(Drawing& drawing, const View& view, const Pane& pane) {
    const vec2 corner =
        pixelFromNdc(ndcFromClip(clipFromWorld(view, pane) * vec4(wallCorners()[4], 1)), pane.width, pane.height);
    const Axes axes = measuredAxes(view, pane);
    int x = 6;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double length = axes.length[static_cast<int>(axis)];
        const vec2 drawn = axes.drawn.at(axis);
        const vec4& color = axisColors.at(axis);
        const std::string text = axisNames.at(axis) + formatted(" %.3f", length);
        drawing.text({x, pane.height - 26}, text, {.color = color});
        x += textWidth(text) + 4;
        if (length < 1e-9) continue;  // seen end on
        drawing.arrow(corner, corner + 2.0 * drawn, {.color = color, .width = 2});
        const vec2 beyond = drawn * (10 / std::hypot(drawn.x, drawn.y));
        drawing.textAround(corner + 2.0 * drawn + beyond, axisNames.at(axis), {.height = 13, .color = color});
    }
}

// Mark the vanishing points, and write how many there are.
static void markVanishingPoints(Drawing& drawing, const View& view, const Pane& pane) {
    const mat4 clip = clipFromWorld(view, pane);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        vec3 direction(0);
        direction[static_cast<int>(axis)] = 1;
        const auto point = vanishingPoint(clip, direction, pane.width, pane.height);
        if (!point) continue;
        const vec4& color = axisColors.at(axis);
        drawing.point(*point, 7, color);
        if (std::min(point->x, point->y) >= 0 && point->x < pane.width - 18 && point->y < pane.height - 28)
            drawing.text(*point + vec2(6, 26), axisNames.at(axis), {.color = color});
    }
    const Meeting meeting = meetingIn(view, pane);
    drawing.text({6, 28}, std::to_string(meeting.points) +
                              (meeting.points == 1 ? " vanishing point" : " vanishing points") +
                              formatted(", met within %.0e px", meeting.miss));
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    glDisable(GL_SCISSOR_TEST);
    const FrameInfo inPixels = frame.inPixels();
    glViewport(0, 0, inPixels.width(), inPixels.height());
    gpu.drawing.begin(frame);
    const FourViews four = views(s);
    for (std::size_t i = 0; i < 4; ++i) {
        const Pane pane = frame.panes(4)[i];
        gpu.drawing.in(pane);
        gpu.drawing.text({6, pane.height - 6}, four.at(i).name);
        (four.at(i).isParallel() ? drawAxes : markVanishingPoints)(gpu.drawing, four.at(i), pane);
    }
    gpu.drawing.draw(frame);
}

}  // namespace mv::projections
