// environment: bodies that mirror and refract what is around them, looked up in a cube map as if it were infinitely far.
#include "environment.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "mv/demo/seen.h"
#include "mv/geometry/bounds.h"
#include "mv/gl/gl.h"
#include "mv/gl/state.h"
#include "mv/math/transform.h"
#include "shared/own_picture.h"

namespace mv::environment {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    glEnable(GL_DEPTH_TEST);
    drawMirroring(gpu, s, scene, frame);
    drawAround(gpu, s, scene, frame);  // room.cpp
    tell(s, frame);
}

void drawMirroring(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    // 1. Draw the surroundings into a cube map, or compute it
    setEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS, s.seamless);
    const auto bindCube = inRoom(s) ? bindRoom : bindSky;
    bindCube(gpu, s, frame);

    // 2. Draw the body, whose shader looks up the cube map
    drawBody(gpu, s, scene, frame);
}

// Bind the cube map of the room, after those of its faces are drawn that have changed. Rays look up no cube map.
void bindRoom(Gpu& gpu, const Settings& s, const Frame& frame) {
    gpu.facesDrawn = 0;
    if (s.lookup == Lookup::rays) return gpu.noCube->bind(0);
    gpu.facesDrawn = drawFaces(gpu, s, frame);  // room.cpp
    gpu.roomMap.bind(0);
}

// Bind the cube map of a sky or of a picture, which is computed.
void bindSky(Gpu& gpu, const Settings& s, const Frame&) {
    gpu.facesDrawn = 0;
    const CubeMap& sky = gpu.skyMap.of({s.cubeSize, s.picture.version()}, [&] { return CubeMap(skyFaces(s), "sky"); });
    sky.bind(0);
}
std::array<FloatPicture, cubeFaces> skyFaces(const Settings& s) {
    return s.picture.isSet() ? ownCube(*s.picture.content(), s.cubeSize) : skyCube(s.cubeSize);
}

// Draw the body. In each pixel the shader reflects and refracts the line of sight, looks up the light from both directions, and
// mixes the two by Fresnel's equations.
void drawBody(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    const Pane pane = paneOf(frame);
    glViewport(pane.x, pane.y, pane.width, pane.height);
    const Program& program = gpu.program;
    program.use();
    program.set("clipFromBody", scene.clipFromWorld() * worldFromBody(s));
    program.set("worldFromBody", worldFromBody(s));
    program.set("worldFromNormal", normalMatrix(worldFromBody(s)));
    program.set("eye", eyeOf(scene));
    setSurface(program, s);

    // Set walls and balls: the lookup by walls needs them, and so do the rays right of the line
    program.set("lookup", inRoom(s) ? static_cast<int>(s.lookup) : 0);
    program.set("raysFrom", splits(s) && !frame.measuring() ? 0.5 * pane.width : 1e9);
    setRoom(program, roomOf(s, frame));
    bodyOf(gpu, s).draw();
}

void setSurface(const Program& program, const Settings& s) {
    const Coating surface = coatingOf(s);
    program.set("material", static_cast<int>(surface.kind));
    program.set("index", surface.index);
    program.set("metalIndex", surface.metal.n);
    program.set("metalAbsorption", surface.metal.k);
    program.set("bySchlick", s.fresnel == Curve::schlick);
    program.set("isSphere", isSphere(s));
    program.set("waysOut", waysOut(s));
}

// The number of surfaces at which light may leave the glass. A formula for it exists for the sphere alone.
int waysOut(const Settings& s) {
    constexpr std::array ofSphere{0, 1, 5};  // in the order of Through
    return isSphere(s) ? ofSphere.at(static_cast<std::size_t>(s.refract)) : 0;
}

Coating coatingOf(const Settings& s) {
    using Kind = Coating::Kind;
    // In the order of Material; a mirror and glass ask for no metal
    const std::array<Coating, 4> coatings{{{Kind::mirror, gold, s.index},
                                           {Kind::metal, gold, s.index},
                                           {Kind::metal, copper, s.index},
                                           {Kind::glass, gold, s.index}}};
    return coatings.at(static_cast<std::size_t>(s.material));
}

// A model of the user's replaces the body, and is as large as the sphere.
const Mesh& bodyOf(Gpu& gpu, const Settings& s) {
    const std::array ofBody{&gpu.round, &gpu.teapotMesh};  // in the order of Body
    if (!s.model.isSet()) return **ofBody.at(std::size_t(s.body));
    return gpu.model.of({s.model.version()}, [&] { return Mesh(fitted(s.model.content()->mesh), "model"); });
}
MeshData fitted(MeshData mesh) {
    const vec3 middle = boundsOf(mesh).middle();
    const double reach = reachOf(mesh);
    for (fvec3& position : mesh.positions) position = fvec3((vec3(position) - middle) / reach);
    return withoutTexCoords(std::move(mesh));
}
// The distance from the middle of the mesh's box to its farthest point.
double reachOf(const MeshData& mesh) {
    const vec3 middle = boundsOf(mesh).middle();
    double reach = 0;
    for (const fvec3& position : mesh.positions) reach = std::max(reach, glm::distance(vec3(position), middle));
    return reach;
}
bool isSphere(const Settings& s) { return s.body == Body::sphere && !s.model.isSet(); }
mat4 worldFromBody(const Settings& s) {
    const bool isTeapot = s.body == Body::teapot && !s.model.isSet();
    return isTeapot ? scale(0.36) * translate(-0.25, -1.55, 0) : mat4(1);
}
vec3 eyeOf(const Scene& scene) { return vec3(glm::inverse(scene.viewFromWorld)[3]); }

// A picture of the user's replaces the surroundings, as a sky does.
bool inRoom(const Settings& s) { return s.around == Around::room && !s.picture.isSet(); }
bool looksUp(const Settings& s) { return !inRoom(s) || s.lookup != Lookup::rays; }
bool splits(const Settings& s) { return inRoom(s) && s.split; }

}  // namespace mv::environment
