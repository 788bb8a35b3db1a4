// Over the picture of cube-cull: letters at the axes, and in a corner the cube's faces moved apart, the culled ones dashed.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cube-cull.h"
#include "mv/gl/state.h"
#include "mv/gl/triangle_count.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::cube_cull {

static const vec4 ink(0.25, 0.25, 0.25, 1), pale(0.7, 0.7, 0.7, 1);

// Name the end of each axis that is nearer to the eye: the cube does not hide it.
static void nameAxes(Drawing& drawing, const Settings& s, const FrameInfo& frame) {
    const mat4 clipFromModel = clipFromView(frame.aspect()) * viewFromModel(s);
    constexpr std::array letters{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        vec3 end(0);
        end[int(axis)] = 1.6;
        const bool isAhead = (viewFromModel(s) * vec4(end, 0)).z < 0;  // the eye looks along -z
        drawing.text(clipFromModel, isAhead ? -end : end, {-4, 8}, (isAhead ? "-" : "") + std::string(letters.at(axis)),
                     {16, ink, vec4(0)});
    }
}

constexpr std::size_t cornersOfFace = 6;  // of two triangles a b c and a c d

// The cube's faces, each moved along its normal.
static MeshData facesApart() {
    MeshData cube = colorCube();
    for (std::size_t first = 0; first < cube.positions.size(); first += cornersOfFace) {
        const fvec3 a = cube.positions[first], b = cube.positions[first + 1], c = cube.positions[first + 2];
        const fvec3 moved = 0.5F * glm::normalize(glm::cross(b - a, c - a));
        for (std::size_t i = first; i < first + cornersOfFace; ++i) cube.positions[i] += moved;
    }
    return cube;
}

// For each face how many of its triangles are culled, outside, and go on.
static std::vector<TriangleCount> fatesOf(const Settings& s, const FrameInfo& frame) {
    const std::vector<fvec4> corners = clipCorners(colorCube(), s, frame.aspect());
    const FaceCulling culling{s.cull != Cull::none, glFaces(s.cull), glWinding(s.winding)};
    std::vector<TriangleCount> fates;
    for (auto first = corners.begin(); first != corners.end(); first += cornersOfFace)
        fates.push_back(sortTriangles({first, first + cornersOfFace}, culling));
    return fates;
}

static void drawDashed(Drawing& drawing, const mat4& clipFromModel, const vec3& from, const vec3& to) {
    constexpr int dashes = 6;
    for (int i = 0; i < dashes; ++i) {
        const double start = (i + 0.1) / dashes, end = (i + 0.7) / dashes;
        drawing.edge(clipFromModel, glm::mix(from, to, start), glm::mix(from, to, end), {ink, 1.6});
    }
}

// Clear the pane, and draw the faces that go on.
static void drawKept(Gpu& gpu, const std::vector<TriangleCount>& fates, const mat4& paneFromModel, const Pane& pane) {
    const StateScope scope;
    glViewport(pane.x, pane.y, pane.width, pane.height);
    glScissor(pane.x, pane.y, pane.width, pane.height);
    setEnabled(GL_SCISSOR_TEST, true);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    setEnabled(GL_CULL_FACE, false);
    setEnabled(GL_DEPTH_TEST, true);
    gpu.program.use();
    gpu.program.set("viewFromModel", mat4(1));
    gpu.program.set("clipFromView", paneFromModel);
    for (std::size_t face = 0; face < fates.size(); ++face) {
        if (fates[face].surviving == 0) continue;
        const Mesh& faces = gpu.apart.of({}, [] { return Mesh(facesApart(), "faces moved apart"); });
        faces.draw(face * cornersOfFace, cornersOfFace);
    }
}

// The faces seen from the right and from above, the eye on the left before them.
static void drawApart(Gpu& gpu, const Settings& s, const Frame& frame) {
    const double size = std::min(frame.width(), frame.height());
    const int width = std::max(1, int(0.42 * size)), height = std::max(1, int(0.3 * size));
    const Pane pane{frame.width() - width, 0, width, height};
    constexpr double farEye = 2.4;  // an eye that is farther away is drawn there
    const vec3 eye(0, 0, std::min(std::abs(s.zDist), farEye)), middle(0, -0.1, 0.28 * farEye);
    const mat4 paneFromEye =
        perspective(25, pane.aspect(), 1, 100) * lookAt(middle + vec3(6, 3.2, 2.2), middle, vec3(0, 1, 0));
    const mat4 paneFromModel = paneFromEye * translate(0, 0, std::abs(s.zDist)) * viewFromModel(s);

    const std::vector<TriangleCount> fates = fatesOf(s, frame);
    drawKept(gpu, fates, paneFromModel, frame.pixels(pane));

    Drawing& drawing = gpu.drawing;
    drawing.in(pane);
    drawing.line(std::array{vec2(0, 0), vec2(0, height), vec2(width, height)}, {pale, 1});
    const MeshData apart = facesApart();
    long culled = 0, outside = 0;
    for (std::size_t face = 0; face < fates.size(); ++face) {
        culled += fates[face].culled;
        outside += fates[face].outside;
        if (fates[face].surviving > 0) continue;
        const auto corner = [&](std::size_t i) { return vec3(apart.positions[face * cornersOfFace + i]); };
        for (const auto& [from, to] : {std::pair(0, 1), {1, 2}, {2, 5}, {5, 0}})
            drawDashed(drawing, paneFromModel, corner(std::size_t(from)), corner(std::size_t(to)));
    }
    drawing.point(paneFromEye, eye, 9, ink);
    drawing.edge(paneFromEye, eye, 0.6 * eye, {ink, 1.2});
    drawing.text(paneFromEye, eye, {-12, 24}, "eye", {13, ink, vec4(0)});
    const std::string beyond = outside > 0 ? ", outside of the view " + std::to_string(outside) : "";
    drawing.text({8, 22}, "culled " + std::to_string(culled) + " of 12 triangles" + beyond, {13, ink, vec4(0)});
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (!s.apart) return;
    gpu.drawing.begin(frame);
    nameAxes(gpu.drawing, s, frame);
    if (s.body == Body::cube) drawApart(gpu, s, frame);
    const Pane whole = frame.pixels({0, 0, frame.width(), frame.height()});
    glViewport(whole.x, whole.y, whole.width, whole.height);
    gpu.drawing.draw(frame);
}

}  // namespace mv::cube_cull
