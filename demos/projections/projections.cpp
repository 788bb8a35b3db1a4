// projections: one house in four panes: as in CAD, in the axonometric and the oblique views, and with vanishing points.
#include "projections.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "mv/gl/functions.h"
#include "mv/math/depth_range.h"
#include "mv/math/projection.h"
#include "mv/math/shear.h"
#include "mv/math/transform.h"
#include "shared/wide_lines.h"

namespace mv::projections {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Let near things hide far ones
    glClearColor(1, 1, 1, 1);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glPolygonOffset(1, 1);
    glEnable(GL_SCISSOR_TEST);
    gpu.lines.use();
    gpu.lines.set("side", vec3(1));

    const FourViews four = views(s);
    for (std::size_t i = 0; i < 4; ++i) {
        const Pane pane = frame.panes(4)[i];
        const mat4 clip = clipFromWorld(four[i], pane);
        frame.show(four[i].name + "FromWorld", clip);

        // Draw the house into its pane, its faces pushed back behind their edges: they alone, since some drivers push lines too
        beginPane(pane);
        gpu.faces.use();
        gpu.faces.set("clipFromWorld", clip);
        glEnable(GL_POLYGON_OFFSET_FILL);
        gpu.house.draw();
        glDisable(GL_POLYGON_OFFSET_FILL);

        // Draw its edges over it. A perspective leaves the colour of an axis, so set grey again
        gpu.lines.use();
        gpu.lines.set("clipFromWorld", clip);
        if (i == 0 || !four[i - 1].isParallel()) gpu.lines.set("color", vec4(0.1, 0.1, 0.1, 1));
        drawWide(frame, pane, [&] { gpu.edges.draw(); });
        if (!four[i].isParallel()) drawWide(frame, pane, [&] { drawToInfinity(gpu, clip, pane); });
    }
}

// Begin a pane. The viewport maps clip space to it, and the scissor confines glClear to it.
void beginPane(const Pane& pane) {
    glViewport(pane.x, pane.y, pane.width, pane.height);
    glScissor(pane.x, pane.y, pane.width, pane.height);
    glClear(GL_COLOR_BUFFER_BIT);
}

// Columns 0 to 2 of a matrix are the images of the directions of the axes, (1, 0, 0, 0) and so on. In a perspective the w of
// a column is not 0, unless the axis is parallel to the picture: then the column is a point of the picture, the vanishing
// point of all lines along the axis.
void drawToInfinity(const Gpu& gpu, const mat4& clipFromWorld, const Pane& pane) {
    // Draw the horizon. (-1, 0, 0, 0) has the same image as (1, 0, 0, 0), and is in front of the eye where that is not
    vec3 side(1);
    for (int axis = 0; axis < 3; ++axis) side[axis] = clipFromWorld[axis].w < 0 ? -1 : 1;
    gpu.lines.set("side", side);
    gpu.lines.set("color", vec4(0.6, 0.6, 0.6, 1));
    gpu.horizon.draw();

    // Draw a line from each corner of the walls to the vanishing point of each axis
    for (int axis = 0; axis < 3; ++axis) {
        vec3 direction(0);
        direction[axis] = 1;
        if (!vanishingPoint(clipFromWorld, direction, pane.width, pane.height)) continue;
        gpu.lines.set("color", axisColors.at(std::size_t(axis)));
        gpu.rays.draw(16 * std::size_t(axis), 16);
    }
}

// The whole house lies within `reach` of its middle.
static const vec3 middle(1.5, 3, 0);
constexpr double reach = 8;

static mat4 turned(double turn, double tilt) { return rotateX(tilt) * rotateY(-turn) * translate(-middle); }

// An axonometric view: the lines of sight are perpendicular to the picture, and the house is turned.
static View axonometric(const std::string& name, double turn, double tilt, double half) {
    const double c = std::cos(radians(turn)), s = std::sin(radians(turn)), up = std::sin(radians(tilt));
    return {name, turned(turn, tilt), half, {std::hypot(c, s * up), std::cos(radians(tilt)), std::hypot(s, c * up)}};
}

// An oblique view: a side of the house is parallel to the picture, and what lies one metre behind it is drawn `length`
// metres further in the direction `angle`.
static View oblique(const std::string& name, double angle, double length, double half) {
    const mat4 shear = shearZ(-length * std::cos(radians(angle)), -length * std::sin(radians(angle)));
    return {name, shear * turned(0, 0), half, {1, 1, length}};
}

static View perspective(const std::string& name, const mat4& turnedFromWorld, double distance, double half,
                        double shift = 0) {
    return {name, translate(0, 0, -distance) * turnedFromWorld, half, vec3(0), distance, shift};
}

FourViews views(const Settings& s) {
    constexpr std::array ofShow{cadViews, axonometricViews, obliqueViews, vanishingViews};
    return ofShow.at(std::size_t(s.show))(s);
}

FourViews cadViews(const Settings& s) {
    return {axonometric("top", 0, 90, 6), perspective("perspective", turned(s.turn, s.tilt), s.distance, 6, s.shift),
            axonometric("front", 0, 0, 6), axonometric("side", 90, 0, 6)};
}

FourViews axonometricViews(const Settings& s) {
    constexpr double isometricTilt = 35.264389682754654;                                    // atan(1/sqrt(2))
    constexpr double dimetricTurn = 20.704811054635432, dimetricTilt = 19.471220634490692;  // x : y : z = 1 : 1 : 1/2
    return {axonometric("isometric", 45, isometricTilt, 7.2), axonometric("dimetric", dimetricTurn, dimetricTilt, 7.2),
            axonometric("trimetric", 60, 15, 7.2), axonometric("yours", s.turn, s.tilt, 7.2)};
}

FourViews obliqueViews(const Settings& s) {
    View planometric = oblique("planometric", -90, 1, 8.5);
    planometric.viewFromWorld =
        planometric.viewFromWorld * translate(middle) * rotateX(90) * rotateY(-45) * translate(-middle);
    return {oblique("cavalier", 45, 1, 8), oblique("cabinet", 45, 0.5, 8), planometric,
            oblique("yours", s.angle, s.length, 8)};
}

FourViews vanishingViews(const Settings& s) {
    return {perspective("one-point", translate(-5.5, -4, 0) * turned(0, 0), 16, 12),
            perspective("two-point", translate(0, -1, 0) * turned(42, 0), 11, 11),
            perspective("three-point", turned(42, 42), 11, 14.5),
            perspective("yours", turned(s.turn, s.tilt), s.distance, 13, s.shift)};
}

mat4 clipFromWorld(const View& view, const Pane& pane) {
    return clipFromView(view, pane.aspect()) * view.viewFromWorld;
}

// All of the house is seen in a narrow pane, too.
double halfShown(const View& view, double aspect) { return view.half * std::max(1.0, 1.1 / aspect); }

mat4 clipFromView(const View& view, double aspect) {
    const double half = halfShown(view, aspect), near = view.distance - reach;
    if (view.isParallel()) return ortho(-half * aspect, half * aspect, -half, half, -2 * reach, 2 * reach);
    if (view.shift == 0) return infinitePerspective(2 * degrees(std::atan(half / view.distance)), aspect, near);
    const double top = near * half / view.distance;
    return infiniteFrustum(-top * aspect, top * aspect, top * (view.shift - 1), top * (view.shift + 1), near);
}

std::array<vec3, 8> wallCorners() {
    const vec3 low(-4, 0, -3), high(4, 3, 3);  // up to the eaves
    std::array<vec3, 8> corners;
    for (int i = 0; i < 8; ++i) corners.at(std::size_t(i)) = glm::mix(low, high, vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
    return corners;
}

}  // namespace mv::projections
