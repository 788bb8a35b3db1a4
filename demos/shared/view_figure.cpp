#include "shared/view_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/formatted.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

const vec4 nearColor(0.05, 0.35, 0.85, 1), farColor(0.85, 0.25, 0.05, 1), charcoal(0.25, 0.25, 0.25, 1),
    pale(0.55, 0.55, 0.55, 1);
constexpr double fovy = 24;  // of the camera that looks from outside

// Corner i of the cube from -1 to 1 is at 1 where bits 0, 1, 2 of i say so of x, y, z.
vec3 cubeCorner(unsigned i) { return 2.0 * vec3(i & 1U, i >> 1 & 1U, i >> 2 & 1U) - 1.0; }

// A camera to the right, above and behind the eye that has all these points in its pane.
mat4 lookAtAll(const std::vector<vec3>& points, const Pane& pane) {
    vec3 low = points.front(), high = points.front();
    for (const vec3& point : points) low = glm::min(low, point), high = glm::max(high, point);
    const vec3 middle = (low + high) / 2.0, towards = glm::normalize(vec3(0.95, 0.55, 0.62));
    double radius = 0;
    for (const vec3& point : points) radius = std::max(radius, glm::length(point - middle));
    const double narrow = std::atan(std::tan(radians(fovy / 2)) * std::min(1.0, pane.aspect()));
    const double distance = 1.04 * radius / std::sin(narrow);
    return perspective(fovy, pane.aspect(), distance / 20, 20 * distance) *
           lookAt(middle + distance * towards, middle, vec3(0, 1, 0));
}

// The cube from -1 to 1, seen from the same side. Its z grows away from the eye, so it is turned about.
mat4 paneFromClip(const Pane& pane) {
    std::vector<vec3> corners;
    for (unsigned i = 0; i < 8; ++i) corners.push_back(1.25 * cubeCorner(i));
    return lookAtAll(corners, pane) * scale(1, 1, -1);
}

// The edges of the cube from -1 to 1, or of the volume that it is made of: blue at the near plane, red at the far one.
void drawEdges(Drawing& drawing, const mat4& paneFromCube) {
    for (const unsigned bit : {4U, 1U, 2U}) {
        for (unsigned i = 0; i < 8; ++i) {
            if ((i & bit) != 0) continue;
            const vec4& color = bit == 4 ? charcoal : (i & 4U) != 0 ? farColor : nearColor;
            drawing.edge(paneFromCube, cubeCorner(i), cubeCorner(i | bit), {color, bit == 4 ? 1.2 : 2.4});
        }
    }
}

void drawAxes(Drawing& drawing, const mat4& paneFromSpace, const vec3& origin, double length, int size) {
    constexpr std::array letters{"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        vec3 along(0);
        along[axis] = length;
        drawing.edge(paneFromSpace, origin, origin + along, {charcoal, 2});
        drawing.text(paneFromSpace, origin + 1.2 * along, {-3, 0.6 * size}, letters.at(std::size_t(axis)),
                     {size, charcoal, vec4(0)});
    }
}

void drawCube(const Program& program, const Mesh& cube, const mat4& clipFromView, const mat4& viewFromModel,
              const Pane& pane) {
    glViewport(pane.x, pane.y, pane.width, pane.height);
    program.set("clipFromView", clipFromView);
    program.set("viewFromModel", viewFromModel);
    cube.draw();
}

}  // namespace

Pane picturePane(const FrameInfo& frame) {
    const int width = std::max(1, int(0.58 * frame.width())), height = std::max(1, int(0.58 * frame.height()));
    return {0, frame.height() - height, width, height};
}
Pane volumePane(const FrameInfo& frame) {
    return {0, 0, std::max(1, int(0.58 * frame.width())), std::max(1, frame.height() - picturePane(frame).height)};
}
Pane cubePane(const FrameInfo& frame) {
    const Pane left = volumePane(frame);
    return {left.width, 0, std::max(1, frame.width() - left.width), left.height};
}

mat4 outsideFromView(const ViewFigure& figure, const Pane& pane) {
    std::vector<vec3> points{vec3(0)};
    for (const vec3& corner : viewVolumeCorners(figure.clipFromView)) points.push_back(corner);
    for (unsigned i = 0; i < 8; ++i) points.emplace_back(figure.viewFromModel * vec4(0.5 * cubeCorner(i), 1));
    return lookAtAll(points, pane);
}

void drawViewFigure(Drawing& drawing, const Program& program, const Mesh& cube, const ViewFigure& figure,
                    const Frame& frame) {
    const Pane volume = volumePane(frame), clip = cubePane(frame), picture = picturePane(frame);
    const mat4 outside = outsideFromView(figure, volume), fromClip = paneFromClip(clip);
    drawCube(program, cube, outside, figure.viewFromModel, frame.pixels(volume));
    drawCube(program, cube, fromClip * figure.clipFromView, figure.viewFromModel, frame.pixels(clip));
    const Pane all = frame.pixels({0, 0, frame.width(), frame.height()});
    glViewport(all.x, all.y, all.width, all.height);

    const int size = std::clamp(frame.height() / 42, 7, 18);
    const TextStyle words{size, charcoal, vec4(0)};
    drawing.begin(frame);
    drawing.in(volume);
    const mat4 outsideFromClip = outside * glm::inverse(figure.clipFromView);
    drawEdges(drawing, outsideFromClip);
    if (figure.isPerspective) {
        for (unsigned i = 0; i < 4; ++i) {
            const vec4 near = glm::inverse(figure.clipFromView) * vec4(cubeCorner(i), 1);
            drawing.edge(outside, vec3(0), vec3(near) / near.w, {pale, 1});
        }
    }
    // A perspective has an eye, in the origin; a box is seen from infinitely far away, and its axes are shown at a corner
    vec3 origin(0);
    if (figure.isPerspective) {
        drawing.point(outside, origin, 8, charcoal);
        drawing.text(outside, origin, {-2.2 * size, -0.6 * size}, "eye", words);
    } else {
        origin = viewVolumeCorners(figure.clipFromView)[0];
    }
    drawAxes(drawing, outside, origin, 0.25 * std::max({std::abs(figure.far), std::abs(figure.near), 1.0}), size);
    for (const auto& [z, color] : {std::pair(-1.0, nearColor), std::pair(1.0, farColor)})
        drawing.point(outsideFromClip, {0, 0, z}, 9, color);
    drawing.text({6, volume.height - 4.0}, figure.isPerspective ? "the pyramid of view" : "the box of view", words);
    drawing.text({6, 1.6 * size}, "near " + formatted("%.3g", figure.near), {size, nearColor, vec4(0)});
    drawing.text({8.0 * size, 1.6 * size}, "far " + formatted("%.3g", figure.far), {size, farColor, vec4(0)});

    drawing.in(clip);
    drawEdges(drawing, fromClip);
    drawAxes(drawing, fromClip, vec3(-1, -1, -1), 0.5, size);
    drawing.text({6, clip.height - 4.0}, "made the cube from -1 to 1", words);
    drawing.text({6, 1.6 * size}, "z = -1", {size, nearColor, vec4(0)});
    drawing.text({6.0 * size, 1.6 * size}, "z = 1", {size, farColor, vec4(0)});

    // The matrix, beside the picture
    drawing.in({picture.width, picture.y, std::max(1, frame.width() - picture.width), picture.height});
    const double column = (frame.width() - picture.width) / 4.4;
    drawing.text({6, picture.height - 6.0}, "what the eye sees, by", words);
    for (int row = 0; row < 4; ++row) {
        for (int i = 0; i < 4; ++i)
            drawing.text({6 + column * i, picture.height - (2.4 + 1.7 * row) * size},
                         formatted("%.3g", figure.clipFromView[i][row] + 0.0),
                         {size, row == 2 ? farColor : charcoal, vec4(0)});
    }
    drawing.text({6, picture.height - 9.6 * size}, "near and far are in the third row", {size, farColor, vec4(0)});
    drawing.draw(frame);
}

void tellStretch(const mat4& clipFromView, const Frame& frame) {
    const double picture = frame.aspect(), volume = std::abs(clipFromView[1][1] / clipFromView[0][0]);
    const double wide = picture / volume;
    if (std::abs(std::log(wide)) < 0.02) return;  // a pixel or two of rounding
    frame.say("Shapes are shown " + formatted("%.2f times as ", std::max(wide, 1 / wide)) +
              (wide > 1 ? "wide" : "high") + " as they are: the picture is " +
              formatted("%.2f times as wide as high, the volume of view ", picture) + formatted("%.2f.", volume));
}

}  // namespace mv
