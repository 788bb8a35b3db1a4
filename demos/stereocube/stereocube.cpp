// stereocube: a wire cube seen by two eyes, one picture in red and one in cyan for coloured glasses, or side by side.
#include "stereocube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "mv/geometry/shapes.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/narrow_view.h"
#include "shared/wide_lines.h"

namespace mv::stereocube {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Lens lens = lensOf(s, frame);
    const Eye left = leftEye(s, lens), right = rightEye(s, lens);
    frame.show("leftFromWorld", left.eyeFromWorld);
    frame.show("clipFromLeft", left.clipFromEye);
    frame.show("rightFromWorld", right.eyeFromWorld);
    frame.show("clipFromRight", right.clipFromEye);
    frame.show("worldFromModel", worldFromModelOf(s));

    // Draw the two pictures beside each other, or over each other. The left eye looks through the red filter and sees the
    // red channel, so the left picture is the one that changes red
    constexpr std::array ofShape{drawWires, drawWires, drawAnaglyph};  // in the order of Shape; shaded.cpp
    const auto drawPictures = isBeside(s) ? drawBeside : ofShape.at(std::size_t(s.shape));
    drawPictures(gpu, s, left, right, frame);
}

// Clear the picture before a mask is set, since the mask holds for glClear, too.
static void clearPaper(const Settings& s) {
    const auto paper = float(s.background == Paper::white);
    glClearColor(paper, paper, paper, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
}

void drawWires(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const Frame& frame) {
    constexpr std::array ofColors{drawLines, drawMasked};  // in the order of Colors
    clearPaper(s);
    ofColors.at(std::size_t(s.colors))(gpu, s, left, right, frame);
}

// Draw the lines in two colours. On black, red lines change red. On white, cyan lines do, since they take red away.
void drawLines(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const FrameInfo& frame) {
    const auto& [red, cyan] = s.background == Paper::white ? std::tie(right, left) : std::tie(left, right);
    drawWire(gpu, s, red, vec4(1, 0, 0, 1), frame);
    drawWire(gpu, s, cyan, vec4(0, 1, 1, 1), frame);
}

// Draw each picture into channels of its own, in black on white or white on black.
void drawMasked(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const FrameInfo& frame) {
    glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
    drawInked(gpu, s, left, frame);
    glClear(GL_DEPTH_BUFFER_BIT);  // the eyes do not hide things from each other
    glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
    drawInked(gpu, s, right, frame);
}

// Draw each picture into a half of its own: the left eye's on the left for a headset, on the right for crossed eyes.
void drawBeside(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const Frame& frame) {
    constexpr std::array ofShape{drawInked, drawInked, drawSurfaces};  // in the order of Shape
    clearPaper(s);
    const int leftColumn = s.eyes == Eyes::crossed ? 1 : 0;
    for (const auto& [eye, column] : {std::pair(&left, leftColumn), std::pair(&right, 1 - leftColumn)}) {
        const auto [x, y, width, height] = paneOf(s, frame, column);
        glViewport(x, y, width, height);
        ofShape.at(std::size_t(s.shape))(gpu, s, *eye, frame);
    }
    glViewport(0, 0, frame.width(), frame.height());
}

// Draw the picture of an eye in black on white, or white on black.
void drawInked(Gpu& gpu, const Settings& s, const Eye& eye, const FrameInfo& frame) {
    drawWire(gpu, s, eye, vec4(vec3(s.background == Paper::black), 1), frame);
}

// Draw the picture of an eye, unless the eye is closed.
void drawWire(Gpu& gpu, const Settings& s, const Eye& eye, const vec4& color, const FrameInfo& frame) {
    const bool isOneOpen = s.eyes == Eyes::left || s.eyes == Eyes::right;
    if (isOneOpen && s.eyes != eye.which) return;
    const Mesh& wire = gpu.wire.of({s.shape, s.four}, [&] { return Mesh(wireOf(s), "cube"); });
    gpu.program->use();
    gpu.program->set("color", color);
    // OpenGL's lines are one pixel wide: draw a wider one as several, side by side
    const Pane pane = paneOf(s, frame, 0);
    for (const vec2& pixels : penOf(lineWidth(frame, s.lineWidth))) {
        const mat4 moved = translate(2 * pixels.x / pane.width, 2 * pixels.y / pane.height, 0);
        gpu.program->set("clipFromModel", moved * eye.clipFromEye * eye.eyeFromWorld * worldFromModelOf(s));
        wire.draw();
    }
}

// The pixels of a pen that is so many pixels wide across and upwards.
std::vector<vec2> penOf(int width) {
    const int half = width / 2;
    std::vector<vec2> pixels;
    for (int x = -half; x <= half; ++x) {
        for (int y = std::abs(x) - half; y <= half - std::abs(x); ++y) pixels.emplace_back(x, y);
    }
    return pixels;
}

// The eyes look along +z with y upwards, so their right is -x: the left eye is the one at positive x.
Eye leftEye(const Settings& s, const Lens& lens) { return eyeAt(s.eyeSep / 2, Eyes::left, s, lens); }
Eye rightEye(const Settings& s, const Lens& lens) { return eyeAt(-s.eyeSep / 2, Eyes::right, s, lens); }

// Turn the eye towards the point ahead of both eyes.
static Eye toedInEye(double x, Eyes which, const Settings& s, const Lens& lens) {
    const vec3 place(x, 0, s.zDist), ahead(0, 0, s.zDist + s.convergence);
    return {which, lookAt(place, ahead, vec3(0, 1, 0)), perspective(lens.fovy, lens.aspect, near, far)};
}

// Look straight ahead, and shift the window so that both eyes' windows are one at the convergence distance.
static Eye offAxisEye(double x, Eyes which, const Settings& s, const Lens& lens) {
    const vec3 place(x, 0, s.zDist), ahead(x, 0, s.zDist + s.convergence);
    FrustumBounds window = frustumBounds(lens.fovy, lens.aspect, near, far);
    const double shift = x * near / s.convergence;
    window.left += shift;
    window.right += shift;
    return {which, lookAt(place, ahead, vec3(0, 1, 0)), frustum(window)};
}

Eye eyeAt(double x, Eyes which, const Settings& s, const Lens& lens) {
    constexpr std::array ofStereo{toedInEye, offAxisEye};  // in the order of Stereo
    return ofStereo.at(std::size_t(s.stereo))(x, which, s, lens);
}

// The vertical angle of view is 50 degrees. A narrow half has these 50 degrees across, and so more upwards.
Lens lensOf(const Settings& s, const FrameInfo& frame) {
    const double aspect = paneOf(s, frame, 0).aspect();
    return {isBeside(s) ? fovyAcross(50, aspect) : 50, aspect};
}

bool isBeside(const Settings& s) { return s.eyes == Eyes::sideBySide || s.eyes == Eyes::crossed; }
bool isShaded(const Settings& s) { return s.shape == Shape::stillLife; }
// The whole picture, or the left (0) or right (1) half of it.
Pane paneOf(const Settings& s, const FrameInfo& frame, int column) {
    if (!isBeside(s)) return {0, 0, frame.width(), frame.height()};
    const int width = std::max(frame.width() / 2, 1);
    return {column * (frame.width() - width), 0, width, frame.height()};
}

MeshData wireOf(const Settings& s) { return s.shape == Shape::hypercube ? wireHypercube(s.four) : wireCube(); }

// The initial angles show the cube from a corner, and the still life from the front and a little above.
mat4 worldFromModelOf(const Settings& s) {
    const vec2 back = isShaded(s) ? vec2(38, 30) : vec2(0, 0);
    return rotateX(s.spinX - back.x) * rotateY(s.spinY - back.y);
}

}  // namespace mv::stereocube
