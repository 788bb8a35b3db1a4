// bump-map: a smooth wall and a smooth ball that are lit as bricks and as an orange, beside the really displaced surface.
#include "bump-map.h"

#include <array>
#include <cmath>

#include "mv/geometry/mesh_tangents.h"
#include "mv/gl/gl.h"
#include "mv/math/transform.h"
#include "shared/relief_maps.h"

namespace mv::bump_map {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    bindMaps(gpu, s);
    glEnable(GL_DEPTH_TEST);

    // Draw the smooth surface, bumped by the method's program
    const Program& program = programOf(gpu, s);
    const Pane left = leftPane(s, frame);
    glViewport(left.x, left.y, left.width, left.height);
    setLight(program, s, frame);
    if (s.method == Method::displaced)
        drawReal(gpu, s, left);
    else
        drawMapped(gpu, program, s, left);

    // Draw the displaced surface beside it
    if (!showsBoth(s) || frame.measuring()) return;
    const Pane right = rightPane(frame);
    glViewport(right.x, right.y, right.width, right.height);
    if (&program != &*gpu.smooth) setLight(*gpu.smooth, s, frame);
    drawReal(gpu, s, right);
}

// The programs differ in how a pixel finds its normal and its place in the texture.
const Program& programOf(Gpu& gpu, const Settings& s) {
    const std::array ofMethod{&gpu.smooth,     &gpu.byHeight,    &gpu.byNormal,
                              &gpu.byParallax, &gpu.byOcclusion, &gpu.smooth};  // in the order of Method
    return **ofMethod.at(static_cast<std::size_t>(s.method));
}
bool usesFrames(Method method) { return method != Method::smooth && method != Method::displaced; }
bool usesNormals(Method method) { return usesFrames(method) && method != Method::height; }

// Set the uniforms that all draws of a program share. Light and eye are in the body's space.
void setLight(const Program& program, const Settings& s, const Frame& frame) {
    const mat3 bodyFromWorld = glm::transpose(mat3(worldFromBody(s)));
    program.use();
    program.set("light", bodyFromWorld * towardsLamp(s));
    program.set("view", bodyFromWorld * towardsEye(s));
    program.set("band", frame.measuring() ? measuredBand(s) : vec2(-1, 1e9));
}

// Make the smooth surface. Each vertex has a tangent frame, and the normals of the map are in that frame.
void makeSmooth(Gpu& gpu, const Settings& s) {
    const MeshTangents made = meshTangents(
        s.body == ReliefBody::orange ? sphere(1, 256, 128) : wallPiece(reliefOf(gpu, s), -wallEnd, wallEnd, 128, 2));
    gpu.flat = Mesh(made.mesh, "smooth surface");
    gpu.tangents = attachTangents(made.tangents, "smooth surface");
}

// Draw the smooth surface. The program reads the maps that its method needs.
void drawMapped(Gpu& gpu, const Program& program, const Settings& s, const Pane& pane) {
    if (gpu.flatFor.changed(s.body, isMirrored(s))) makeSmooth(gpu, s);
    program.set("clipFromBody", sceneAt(s, pane.aspect()).clipFromWorld());
    if (usesFrames(s.method)) program.set("keepsSign", s.sign || !isMirrored(s));
    if (usesNormals(s.method)) program.set("normals", 1);
    if (usesFrames(s.method) && s.method != Method::normal) {
        program.set("depth", s.depth);
        program.set("unitsOfRepeat", unitsOfRepeat(s.body));
        program.set("isRound", s.body == ReliefBody::orange);
        program.set("leastCosine", std::sin(pi / s.mapSize));
    }
    if (s.method == Method::occlusion) program.set("layers", s.layers);
    gpu.flat.draw();
}

// Draw the displaced surface with its own normals. The wall is drawn in as many pieces as are in view.
void drawReal(Gpu& gpu, const Settings& s, const Pane& pane) {
    constexpr int tileCells = 160;   // along a side of a wall piece, 2 units long
    constexpr int orangeRows = 320;  // from pole to pole
    if (gpu.realFor.changed(s.body, s.picture.version(), s.picture.isSet() ? s.mapSize : 0, s.depth, isMirrored(s))) {
        const Relief relief = reliefOf(gpu, s);
        gpu.real = Mesh(displaced(relief, s.body == ReliefBody::orange ? sphere(1, 2 * orangeRows, orangeRows)
                                                                       : wallPiece(relief, 0, 2, tileCells, tileCells)),
                        "displaced surface");
        if (isMirrored(s))
            gpu.turned = Mesh(displaced(relief, wallPiece(relief, -2, 0, tileCells, tileCells)), "mirrored piece");
    }
    const mat4 clipFromWorld = sceneAt(s, pane.aspect()).clipFromWorld();
    const auto [first, last] = piecesInView(s, pane.aspect());
    for (int i = first; i <= last; ++i) {
        const bool isTurned = isMirrored(s) && i < 0;
        gpu.smooth->set("clipFromBody", clipFromWorld * translate(isTurned ? 2 * i + 2 : 2 * i, 0, 0));
        (isTurned ? gpu.turned : gpu.real).draw();
    }
}

}  // namespace mv::bump_map
