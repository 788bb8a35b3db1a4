// bump-map: a smooth wall and a smooth ball that are lit as bricks and as an orange, beside the really displaced surface.
#include "bump-map.h"

#include <array>
#include <cmath>
#include <utility>

#include "mv/geometry/mesh_tangents.h"
#include "mv/gl/gl.h"
#include "mv/math/transform.h"
#include "shared/relief_maps.h"

namespace mv::bump_map {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    drawBumped(gpu, s, frame);
    if (showsBoth(s)) drawDisplaced(gpu, s, rightPane(frame), frame);
}

void drawBumped(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofMethod{drawSmooth,     drawByHeight,    drawByNormal,
                                  drawByParallax, drawByOcclusion, drawDisplaced};  // in the order of Method

    bindMaps(gpu, s);  // maps.cpp
    glEnable(GL_DEPTH_TEST);
    ofMethod.at(std::size_t(s.method))(gpu, s, leftPane(s, frame), frame);
}

// Each method has its program, which finds a pixel's normal and its place in the texture in its own way.
void drawSmooth(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame) {
    const Program& program = begin(*gpu.smooth, s, pane, frame);
    drawFlat(gpu, program, s, pane);
}
void drawByHeight(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame) {
    const Program& program = begin(*gpu.byHeight, s, pane, frame);
    setFrames(program, s);
    setRelief(program, s);
    drawFlat(gpu, program, s, pane);
}
void drawByNormal(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame) {
    const Program& program = begin(*gpu.byNormal, s, pane, frame);
    setFrames(program, s);
    program.set("normals", 1);
    drawFlat(gpu, program, s, pane);
}
void drawByParallax(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame) {
    const Program& program = begin(*gpu.byParallax, s, pane, frame);
    setFrames(program, s);
    program.set("normals", 1);
    setRelief(program, s);
    drawFlat(gpu, program, s, pane);
}
void drawByOcclusion(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame) {
    const Program& program = begin(*gpu.byOcclusion, s, pane, frame);
    setFrames(program, s);
    program.set("normals", 1);
    setRelief(program, s);
    program.set("layers", s.layers);
    drawFlat(gpu, program, s, pane);
}
// The displaced surface is no bump: its vertices are where the relief is.
void drawDisplaced(Gpu& gpu, const Settings& s, const Pane& pane, const Frame& frame) {
    const Program& program = begin(*gpu.smooth, s, pane, frame);
    drawReal(gpu, program, s, pane);
}

// Begin a pane, and set the uniforms that all programs have. Light and eye are in the body's space.
const Program& begin(const Program& program, const Settings& s, const Pane& pane, const Frame& frame) {
    const mat3 bodyFromWorld = glm::transpose(mat3(worldFromBody(s)));
    glViewport(pane.x, pane.y, pane.width, pane.height);
    program.use();
    program.set("light", bodyFromWorld * towardsLamp(s));
    program.set("view", bodyFromWorld * towardsEye(s));
    program.set("band", frame.measuring() ? measuredBand(s) : vec2(-1, 1e9));
    return program;
}

// Set whether tangent frames keep their sign, which is -1 where the texture is mirrored.
void setFrames(const Program& program, const Settings& s) { program.set("keepsSign", s.sign || !isMirrored(s)); }

// Set what tells the relief's depth from the map of heights.
void setRelief(const Program& program, const Settings& s) {
    program.set("depth", s.depth);
    program.set("unitsOfRepeat", unitsOfRepeat(s.body));
    program.set("isRound", s.body == ReliefBody::orange);
    program.set("leastCosine", std::sin(pi / s.mapSize));
}

// Draw the smooth surface.
void drawFlat(Gpu& gpu, const Program& program, const Settings& s, const Pane& pane) {
    const SmoothSurface& flat = gpu.flat.of({s.body, isMirrored(s)}, [&] { return makeSmooth(reliefOf(gpu, s)); });
    program.set("clipFromBody", sceneAt(s, pane.aspect()).clipFromWorld());
    flat.mesh.draw();
}

// Make the smooth surface. Each vertex has a tangent frame, and the normals of the map are in that frame.
SmoothSurface makeSmooth(const Relief& relief) {
    const MeshTangents made = meshTangents(
        relief.body == ReliefBody::orange ? sphere(1, 256, 128) : wallPiece(relief, -wallEnd, wallEnd, 128, 2));
    Mesh mesh(made.mesh, "smooth surface");
    return {std::move(mesh), attachTangents(made.tangents, "smooth surface")};
}

// Draw the displaced surface with its own normals. The wall is drawn in as many pieces as are in view.
void drawReal(Gpu& gpu, const Program& program, const Settings& s, const Pane& pane) {
    const DisplacedSurface& real =
        gpu.real.of({s.body, s.picture.version(), s.picture.isSet() ? s.mapSize : 0, s.depth, isMirrored(s)},
                    [&] { return makeDisplaced(reliefOf(gpu, s)); });
    const mat4 clipFromWorld = sceneAt(s, pane.aspect()).clipFromWorld();
    const auto [first, last] = piecesInView(s, pane.aspect());
    for (int i = first; i <= last; ++i) {
        const bool isTurned = isMirrored(s) && i < 0;
        program.set("clipFromBody", clipFromWorld * translate(isTurned ? 2 * i + 2 : 2 * i, 0, 0));
        (isTurned ? real.turned : real.mesh).draw();
    }
}

DisplacedSurface makeDisplaced(const Relief& relief) {
    constexpr int tileCells = 160;   // along a side of a wall piece, 2 units long
    constexpr int orangeRows = 320;  // from pole to pole
    DisplacedSurface made;
    made.mesh =
        Mesh(displaced(relief, relief.body == ReliefBody::orange ? sphere(1, 2 * orangeRows, orangeRows)
                                                                 : wallPiece(relief, 0, 2, tileCells, tileCells)),
             "displaced surface");
    if (relief.isMirrored)
        made.turned = Mesh(displaced(relief, wallPiece(relief, -2, 0, tileCells, tileCells)), "mirrored piece");
    return made;
}

}  // namespace mv::bump_map
