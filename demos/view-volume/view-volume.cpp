// view-volume: a camera seen from outside, with what it sees and what it does not; and the same after its projection.
#include "view-volume.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/geometry/bounds.h"
#include "mv/geometry/edges.h"
#include "mv/geometry/in_volume.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/narrow_view.h"
#include "shared/wide_lines.h"

namespace mv::view_volume {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    glClearColor(1, 1, 1, 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);

    // Take the world to clip space by the camera's matrix. In the right pane one more matrix looks at the result
    const std::vector<Pane> panes = panesOf(frame);
    const mat4 clipFromWorld = clipFromCamera(s) * cameraFromWorld(s);
    const mat4 stageFromWorld = stageFromCamera(s) * cameraFromWorld(s);
    const mat4 outside = outsideFromWorld(s, panes[0]), right = paneFromStage(s, panes[1]);
    frame.show("clipFromWorld", clipFromWorld);
    frame.show("outsideFromWorld", outside);
    frame.show(s.stage == Stage::cube ? "cubeFromClip" : "paneFromStage", right);

    // Draw the kept things, from outside and after the projection. In a plane nothing hides anything, so draw only edges
    const Kept kept = keptOf(gpu, s);
    gpu.faces.use();
    gpu.faces.set("clipFromWorld", clipFromWorld);
    beginPane(gpu, panes[0], outside, false);
    drawThings(gpu, kept, gpu.house, gpu.tree);
    drawWide(frame, panes[0], [&] { gpu.ground.draw(); });
    beginPane(gpu, panes[1], right * stageFromWorld, true);
    if (s.stage == Stage::plane)
        drawWide(frame, panes[1], [&] { drawThings(gpu, kept, *gpu.houseOutline, *gpu.treeOutline); });
    else
        drawThings(gpu, kept, gpu.house, gpu.tree);
    drawWide(frame, panes[1], [&] { gpu.ground.draw(); });
}

// Divide the picture into two panes, side by side or, where it is higher than wide, above each other.
std::vector<Pane> panesOf(const FrameInfo& frame) {
    if (!frame.isUpright()) return frame.panes(2);
    const int half = std::max(1, frame.height() / 2);
    return {{0, frame.height() - half, frame.width(), half}, {0, 0, frame.width(), std::max(1, half - 1)}};
}

// Leave out each object that lies wholly outside one plane.
Kept keptOf(const Gpu& gpu, const Settings& s) {
    // A matrix maps points on its right, and maps planes back on its left
    SixPlanes worldPlanes = cameraPlanes(s);
    for (vec4& plane : worldPlanes) plane = plane * cameraFromWorld(s);

    Kept kept;
    for (std::size_t i = 0; i < gpu.things.size(); ++i) {
        const InVolume place = s.round == Round::box
                                   ? hullInVolume(gpu.boxes[i], worldPlanes)
                                   : ballInVolume(gpu.balls[i].center, gpu.balls[i].radius, worldPlanes);
        if (s.cull && place == InVolume::outside) continue;
        kept.things.push_back(i);
        kept.crossing += int(place != InVolume::inside);
    }
    return kept;
}

SixPlanes cameraPlanes(const Settings& s) {
    if (s.planes == Planes::matrix) return planesFromClip(clipFromCamera(s));
    if (s.planes == Planes::floatMatrix) return planesInFloat(clipFromCamera(s));
    if (s.projection == Projection::perspective) return perspectivePlanes(fovy, aspect, s.nearUsed(), s.far);
    return planesOfBox(s);
}

// The planes of Gribb and Hartmann as most programs have them: sums of the matrix's rows, all in float. A normal that has
// cancelled to 0 stays 0, and its plane excludes nothing.
SixPlanes planesInFloat(const mat4& clipFromCamera) {
    const fmat4 rows = glm::transpose(fmat4(clipFromCamera));
    SixPlanes planes;
    for (int i = 0; i < 6; ++i) {
        const fvec4 plane = i % 2 == 0 ? rows[3] + rows[i / 2] : rows[3] - rows[i / 2];
        const float length = glm::length(fvec3(plane));
        planes[std::size_t(i)] = length == 0 ? vec4(0) : vec4(plane / length);
    }
    return planes;
}

// The box of the parallel projection is as wide as the pyramid at 16 m.
double boxHalf() { return 16 * std::tan(radians(fovy / 2)); }

SixPlanes planesOfBox(const Settings& s) {
    const double h = boxHalf();
    return {vec4(1, 0, 0, h * aspect), vec4(-1, 0, 0, h * aspect),    vec4(0, 1, 0, h),
            vec4(0, -1, 0, h),         vec4(0, 0, -1, -s.nearUsed()), vec4(0, 0, 1, s.far)};
}

mat4 clipFromCamera(const Settings& s) {
    const double h = boxHalf();
    if (s.projection == Projection::perspective) return perspective(fovy, aspect, s.nearUsed(), s.far);
    return ortho(-h * aspect, h * aspect, -h, h, s.nearUsed(), s.far);
}

// The camera stands 3 m high and looks along -z when pan is 0.
mat4 cameraFromWorld(const Settings& s) { return rotateY(-s.pan) * translate(0, -3, 0); }

// Turn the camera in the left pane and the cube in the right pane by the same angles.
mat4 turned(const Settings& s) { return rotateX(s.tilt) * rotateY(-s.turn); }

mat4 outsideFromWorld(const Settings& s, const Pane& pane) {
    // In a narrow pane widen the angle, so that the eye and the far plane stay in it
    return perspective(fovyAcross(40, pane.aspect(), 0.99), pane.aspect(), 1, 200) * translate(0, 0, -68) * turned(s) *
           translate(0, -2, 19);
}

// Clip space counts depth away from the camera, so the cube is mirrored before it is turned.
mat4 cubeFromClip(const Settings& s, const Pane& pane) {
    const double half = 1.9 / std::min(1.0, pane.aspect());
    return ortho(-half * pane.aspect(), half * pane.aspect(), -half, half, -4, 4) * turned(s) * scale(1, 1, -1);
}

void beginPane(const Gpu& gpu, const Pane& pane, const mat4& paneFromWorld, bool isCutOpen) {
    glViewport(pane.x, pane.y, pane.width, pane.height);
    glScissor(pane.x, pane.y, pane.width, pane.height);
    glClear(GL_COLOR_BUFFER_BIT);
    gpu.faces.set("paneFromWorld", paneFromWorld);
    gpu.faces.set("cutOpen", isCutOpen);
}

void drawThings(const Gpu& gpu, const Kept& kept, const Mesh& house, const Mesh& tree) {
    for (const std::size_t i : kept.things) {
        gpu.faces.set("worldFromObject", gpu.things[i].worldFromObject);
        (i == 0 ? house : tree).draw();
    }
    gpu.faces.set("worldFromObject", mat4(1));
}

Corners boxOf(const SceneObject& object) {
    Corners corners = boundsOf(object.mesh).corners();
    for (vec3& corner : corners) corner = vec3(object.worldFromObject * vec4(corner, 1));
    return corners;
}

Ball ballOf(const SceneObject& object) {
    Ball ball{boundsOf(object.mesh, object.worldFromObject).middle(), 0};
    for (const fvec3& position : object.mesh.positions) {
        const vec3 place(object.worldFromObject * vec4(vec3(position), 1));
        ball.radius = std::max(ball.radius, glm::distance(place, ball.center));
    }
    return ball;
}

// The edges of a body, in grey.
MeshData outlineOf(const MeshData& mesh) {
    MeshData edges = edgesOf(mesh);
    edges.normals.assign(edges.positions.size(), fvec3(0, 1, 0));
    edges.colors.assign(edges.positions.size(), fvec4(0.2F, 0.2F, 0.2F, 1));
    return edges;
}

// Lines on the ground, 4 m apart, from below the camera to the last trees.
MeshData groundLines() {
    MeshData mesh;
    mesh.primitive = Primitive::lines;
    const auto add = [&](const vec3& from, const vec3& to) {
        mesh.positions.insert(mesh.positions.end(), {fvec3(from), fvec3(to)});
    };
    for (int z = 0; z <= 40; z += 4) add({-16, 0, -z}, {16, 0, -z});
    for (int x = -16; x <= 16; x += 4) add({x, 0, 0}, {x, 0, -40});
    mesh.normals.assign(mesh.positions.size(), fvec3(0, 1, 0));
    mesh.colors.assign(mesh.positions.size(), fvec4(0.60F, 0.66F, 0.56F, 1));
    return mesh;
}

}  // namespace mv::view_volume
