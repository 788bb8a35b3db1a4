// shading: where the light of a surface is computed (once, for a face, at its corners, at every pixel), and by which model.
#include "shading.h"

#include <array>

#include "mv/geometry/shapes.h"
#include "mv/geometry/teapot.h"
#include "mv/gl/functions.h"
#include "mv/math/transform.h"

namespace mv::shading {

static const vec3 bodyColor(0.80, 0.35, 0.15);

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Mesh& body = gpu.body.of({s.body, s.edges}, [&] { return Mesh(withoutTexCoords(bodyOf(s)), "body"); });
    const mat4 clipFromWorld = sceneOf(s, frame).clipFromWorld(), clipFromBody = clipFromWorld * worldFromBody(s);
    frame.show("worldFromBody", worldFromBody(s));
    frame.show("clipFromWorld", clipFromWorld);

    // Draw the body by the program of the chosen shading
    glEnable(GL_DEPTH_TEST);
    const Program& program = programOf(gpu, s.shading);
    program.use();
    program.set("clipFromBody", clipFromBody);
    program.set("color", bodyColor);
    if (s.shading != Shading::own) light(program, s);
    body.draw();
}

// The shaders differ in where they call the same function of shaders/include/reflection.glsl.
const Program& programOf(Gpu& gpu, Shading shading) {
    const std::array ofShading{&gpu.plain, &gpu.byFace, &gpu.byVertex, &gpu.byPixel};  // in the order of Shading
    return **ofShading.at(static_cast<std::size_t>(shading));
}

// Set lamp, eye and material. Normals have a matrix of their own.
void light(const Program& program, const Settings& s) {
    const Material material = materialOf(s.material);
    program.set("worldFromBody", worldFromBody(s));
    program.set("worldFromNormal", normalMatrix(worldFromBody(s)));
    program.set("lamp", lampOf(s));
    program.set("eye", eye);
    program.set("diffusePart", material.diffuse);
    program.set("emitted", material.emitted);
    program.set("highlightPart", material.highlight);
    program.set("exponent", s.exponent);
    program.set("lobe", static_cast<int>(material.isBrushed ? Lobe::brushed : s.lobe));
    program.set("middleWithin", 6.0 / 7 * sphereRadius);
}

Material materialOf(Kind kind) {
    constexpr std::array<Material, 5> materials{{
        {.diffuse = 0.75, .highlight = 0.5, .emitted = 0.2},                     // plastic
        {.diffuse = 0.8, .highlight = 0, .emitted = 0.2},                        // diffuse
        {.diffuse = 0.1, .highlight = 0.9, .emitted = 0.1},                      // mirror-like
        {.diffuse = 0.2, .highlight = 0.75, .emitted = 0.2, .isBrushed = true},  // brushed
        {.diffuse = 0.3, .highlight = 0.2, .emitted = 0.7},                      // emitting
    }};
    return materials.at(static_cast<std::size_t>(kind));
}

static MeshData sphereOf(int edges) { return sphere(sphereRadius, edges, edges / 2); }
static MeshData teapotOf(int edges) { return tessellated(teapot(), edges / 4); }
MeshData bodyOf(const Settings& s) {
    constexpr std::array ofBody{sphereOf, teapotOf};  // in the order of Body
    return ofBody.at(std::size_t(s.body))(s.edges);
}

// Turn the body about its middle.
mat4 worldFromBody(const Settings& s) {
    const std::array placed{mat4(1), scale(0.66) * translate(-0.2, -1.5, 0)};  // in the order of Body
    return rotateX(s.spinX) * rotateY(s.spinY) * placed.at(std::size_t(s.body));
}

vec3 lampOf(const Settings& s) { return 2.6 * vec3(rotateY(s.lampTurn) * rotateX(-s.lampHeight) * vec4(0, 0, 1, 0)); }

}  // namespace mv::shading
