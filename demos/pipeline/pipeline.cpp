// pipeline: one vertex of a cube on its way through model, world, camera, clip and device space to its pixel.
#include "pipeline.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/matrix.hpp>

#include "gpu_product.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::pipeline {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Clear the view, and set the viewport, which maps device space to its pixels
    const Pane pane = viewIn(frame);
    glEnable(GL_SCISSOR_TEST);
    glScissor(pane.x, pane.y, pane.width, pane.height);
    glClearColor(0.92F, 0.95F, 0.98F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glViewport(pane.x, pane.y, pane.width, pane.height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);

    // Give the program the matrices of all steps
    const Program& program = programOf(gpu, s);
    program.use();
    for (const Step& step : steps(s, pane.aspect())) {
        frame.show(matrixName(step), step.uploaded);
        program.set(matrixName(step).c_str(), step.uploaded);
    }
    if (s.products == Products::shader) program.set("wanted", 0);  // clip space

    // Draw the cube, and mark the vertex so that it is seen through the cube
    gpu.cube.draw();
    glDepthFunc(GL_ALWAYS);
    gpu.corners.draw(std::size_t(s.vertex), 1);
}

Program& programOf(Gpu& gpu, const Settings& s) { return s.products == Products::shader ? *gpu.byThree : *gpu.byOne; }

std::vector<Step> steps(const Settings& s, double aspect) {
    const mat4 m = worldFromModel(s), v = cameraFromWorld(s), p = clipFromCamera(s, aspect), all = p * v * m;
    if (s.products == Products::shader)
        return {{"world", "model", m, m}, {"camera", "world", v, v}, {"clip", "camera", p, p}};
    return {{"clip", "model", s.products == Products::once ? all : mat4(fmat4(p) * fmat4(v) * fmat4(m)), all}};
}

std::string matrixName(const Step& step) {
    return step.to + "From" + char(std::toupper(step.from[0])) + step.from.substr(1);
}

// Turn the cube, then move it into the world.
mat4 worldFromModel(const Settings& s) {
    const mat4 m = translate(s.offset + 0.2, 0.1, 0) * rotateX(s.spinX) * rotateY(s.spinY);
    return s.matrices == Matrices::slideModel ? glm::transpose(m) : m;
}

// The eye always looks along `gaze`, so it can move past the cube.
mat4 cameraFromWorld(const Settings& s) {
    const vec3 gaze = vec3(-3, -2, -6) / 7.0;  // unit length
    const vec3 eye = vec3(s.offset, 0, 0) - gaze * s.distance;
    return lookAt(eye, eye + gaze, vec3(0, 1, 0));
}

// Scale x and y by the angle of view, map z from near and far to -w and w, and take -z as w.
mat4 clipFromCamera(const Settings& s, double aspect) {
    const double near = s.near, far = s.far;
    mat4 m = perspective(50, aspect, near, far);
    if (s.matrices == Matrices::slideProjection) {  // rows (0, 0, f/(f-n), n f/(n-f)) and (0, 0, 1, 0)
        m[2] = vec4(0, 0, far / (far - near), 1);
        m[3] = vec4(0, 0, near * far / (near - far), 0);
    }
    return m;
}

bool isInView(const vec4& clip) { return std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) <= clip.w; }
vec3 deviceFromClip(const vec4& clip) { return vec3(clip) / clip.w; }
vec3 pixelFromDevice(const vec3& device, const Pane& pane) {
    return (device + 1.0) / 2.0 * vec3(pane.width, pane.height, 1);
}

Clip clipOf(const Settings& s, double aspect) {
    fvec4 value(corner(s.vertex), 1);
    vec4 exact(value);
    for (const Step& step : steps(s, aspect)) {
        value = gpuProduct(fmat4(step.uploaded), value);
        exact = step.exact * exact;
    }
    return {vec4(value), exact};
}

// The numbers stand beside the view, or above it where that leaves the view more room.
bool numbersBeside(const FrameInfo& units) {
    const int left = units.width() - numbersWidth;
    return left >= 280 || left >= units.height() - numbersHeight;
}
double numbersScale(const FrameInfo& units) {
    const double width = units.width(), height = units.height();
    const double room = numbersBeside(units) ? std::min(width * 3 / 5 / numbersWidth, height / numbersHeight)
                                             : std::min(width / numbersWidth, height * 3 / 4 / numbersHeight);
    return room < 0.5 ? 0 : std::min(1.0, room);  // nobody could read them
}
Pane viewIn(const FrameInfo& frame) {
    const FrameInfo units = frame.inUnits();
    const double scale = numbersScale(units);
    const int numbersAcross = int(numbersWidth * scale), numbersUp = int(numbersHeight * scale);
    const bool beside = numbersBeside(units) || scale == 0;
    const int width = beside ? std::max(1, units.width() - numbersAcross) : units.width();
    const int height = beside ? units.height() : std::max(1, units.height() - numbersUp);
    return frame.fromUnits({0, 0, width, std::min(height, width)});  // in a higher one the cube would be cut
}

vec3 corner(int i) { return half * (2.0 * vec3(i & 1, i >> 1 & 1, i >> 2 & 1) - 1.0); }

MeshData cubeFaces() {
    MeshData faces = colorCube();  // of edge 1
    for (fvec3& position : faces.positions) position *= float(2 * half);
    return faces;
}

MeshData cubeCorners() {
    MeshData eight;
    eight.primitive = Primitive::points;
    for (int i = 0; i < 8; ++i) eight.positions.emplace_back(corner(i));
    eight.colors.assign(8, fvec4(0, 0, 0, 1));
    return eight;
}

}  // namespace mv::pipeline
