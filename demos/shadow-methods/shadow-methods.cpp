// shadow-methods: one scene, and its shadows by every method: side by side, or subtracted.
#include "shadow-methods.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "shared/z_fail.h"

namespace mv::shadow_methods {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = beginScene(gpu, s, secondOf(s), frame);
    frame.show("viewFromWorld", scene.viewFromWorld);
    frame.show("clipFromView", scene.clipFromView);

    // Draw the scene by one method, by two side by side, or the difference of two
    gpu.found.reset();
    if (s.show == Show::difference) return drawDifference(gpu, s, scene, frame);
    if (s.against == Against::off) return drawScene(gpu, scene, s.method);
    drawSplit(gpu, s, scene, frame);
}

// Make the map and the volumes, where the first method or the one beside it needs them.
Scene beginScene(Gpu& gpu, const Settings& s, Method beside, const Frame& frame) {
    Scene scene = seen(sceneOf(s, frame), frame);
    gpu.meshes.follow(scene);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    if ((usesMap(s.method) || usesMap(beside)) && makeMap(gpu, s, scene)) frame.bindTarget();
    if (s.method == Method::volume || beside == Method::volume) {
        if (!s.keep) gpu.volumes.forget();
        gpu.volumes.follow(scene, scene.lights[0].position);
    }
    return scene;
}

// Draw one method left of the split, the other right of it, and a white line between them.
void drawSplit(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    const int middle = middleOf(s, frame);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, middle, frame.height());
    if (middle > 0) drawScene(gpu, scene, s.method);
    if (middle == frame.width()) return;
    glScissor(middle, 0, frame.width() - middle, frame.height());
    drawScene(gpu, scene, secondOf(s));
    glScissor(middle, 0, 1, frame.height());
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void drawObject(const Program& program, const Scene& scene, const SceneObject& object, const Mesh& mesh) {
    program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
    program.set("worldFromObject", object.worldFromObject);
    program.set("color", object.color);
    mesh.draw();
}

// Draw the scene with its shadows by one method: as a picture, or for a study as the lit fraction of each pixel.
void drawScene(Gpu& gpu, const Scene& scene, Method by) {
    constexpr std::array ofMethod{drawLit, drawByMatrix, drawByVolumes, drawByMap, drawByMap, drawByMap, drawByMap};
    ofMethod.at(std::size_t(by))(gpu, scene, by);
}

// Draw the scene as if nothing stood in the light.
void drawLit(Gpu& gpu, const Scene& scene, Method) {
    const Program& program = useLight(gpu, scene);
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) drawObject(program, scene, object, mesh);
}

// Draw the casters again, flattened onto the planes.
void drawByMatrix(Gpu& gpu, const Scene& scene, Method) {
    // Draw the scene in full light, and store in the stencil buffer the number of the plane seen, 0 for a body
    const Program& program = useLight(gpu, scene);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    int place = 0;
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        ++place;
        glStencilFunc(GL_ALWAYS, object.casts ? 0 : place, ~0U);
        drawObject(program, scene, object, mesh);
    }

    // Draw over each plane where it is seen. Without depth test and blending, no shadow can show twice
    glDisable(GL_DEPTH_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    drawFlattened(gpu, scene);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
}

void drawFlattened(Gpu& gpu, const Scene& scene) {
    const Program& program = *gpu.flat;
    program.use();
    int place = 0;
    for (const SceneObject& plane : scene.objects) {
        ++place;
        if (plane.casts) continue;
        const vec3 normal(plane.worldFromObject[1]), origin(plane.worldFromObject[3]);
        const mat4 flat = shadowProjection(scene.lights[0].position, {normal, -glm::dot(normal, origin)}, origin);
        const mat4 clipFromFlat = scene.clipFromWorld() * translate(origin) * flat;
        glStencilFunc(GL_EQUAL, place, ~0U);
        program.set("color", plane.color);
        for (const auto& [object, mesh] : gpu.meshes.castersOf(scene)) {
            program.set("clipFromObject", clipFromFlat * translate(-origin) * object.worldFromObject);
            mesh.draw();
        }
    }
}

// Count the volumes behind the visible surfaces by z-fail, and draw the scene again without the light where the count is not 0.
void drawByVolumes(Gpu& gpu, const Scene& scene, Method by) {
    drawLit(gpu, scene, by);

    // Count the volumes. Colours and depths stay as they are
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gpu.flat->use();
    countByZFail(gpu.volumes, scene, *gpu.flat);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_CULL_FACE);

    // Draw the shadow
    glStencilFunc(GL_NOTEQUAL, 0, ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glDepthFunc(GL_EQUAL);
    const Program& program = *gpu.byLight;
    program.use();
    program.set("lit", 0.0);
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) drawObject(program, scene, object, mesh);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

// Draw the scene once. The shader looks up each point in the map.
void drawByMap(Gpu& gpu, const Scene& scene, Method by) {
    const Program& program = *gpu.byMap;
    program.use();
    program.set("light", scene.lights[0].position);
    gpu.map.bind(1, by == Method::map ? DepthLookup::compareNearest : DepthLookup::compareLinear);
    program.set("map", 1);
    program.set("side", looksAlong(by));
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        program.set("mapFromObject", gpu.lightView->mapFromWorld() * object.worldFromObject);
        drawObject(program, scene, object, mesh);
    }
}

// Draw the map as the light sees the scene. The map is kept while neither the light nor a caster moves.
bool makeMap(Gpu& gpu, const Settings& s, const Scene& scene) {
    const bool isStale = gpu.mapFor.changed(s.scene, s.ballHeight, s.resolution, s.receiver, s.slopeBias);
    if (!isStale && s.keep) return false;
    const LightView& light = gpu.lightView.of(
        {s.scene, s.ballHeight}, [&] { return fitLightView(scene.lights[0].position, casterPoints(scene)); });
    gpu.map.begin(s.resolution, "shadow map");
    glClear(GL_DEPTH_BUFFER_BIT);

    // Without the receiver draw only back faces: they bound the shadow as well, and no lit face is there to shade itself
    if (!s.receiver) glCullFace(GL_FRONT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(float(s.slopeBias), float(2 * s.slopeBias));
    gpu.flat->use();
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        if (!s.receiver && !object.casts) continue;
        gpu.flat->set("clipFromObject", light.clipFromWorld() * object.worldFromObject);
        mesh.draw();
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glCullFace(GL_BACK);
    return true;
}

// Use the program without shadows, in full light.
const Program& useLight(Gpu& gpu, const Scene& scene) {
    gpu.byLight->use();
    gpu.byLight->set("light", scene.lights[0].position);
    gpu.byLight->set("lit", 1.0);
    return *gpu.byLight;
}

bool usesMap(Method method) { return method >= Method::map; }
int looksAlong(Method method) {
    constexpr std::array ofMethod{0, 0, 0, 1, 1, 3, 5};
    return ofMethod.at(std::size_t(method));
}

// The method right of the split, or the first where there is no second.
Method secondOf(const Settings& s) { return s.against == Against::off ? s.method : Method(int(s.against) - 1); }

int middleOf(const Settings& s, const Frame& frame) { return int(std::lround(s.split * frame.width())); }

}  // namespace mv::shadow_methods
