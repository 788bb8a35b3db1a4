// shadow-lights: one to eight lights that move, each with its own shadows, by maps or by volumes.
#include "shadow-lights.h"

#include <string>

#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/lamp_reach.h"
#include "shared/z_fail.h"

namespace mv::shadow_lights {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    const std::vector<std::size_t> reaching = lightsThatReach(s, scene);
    const bool byMaps = s.method == Method::maps;
    frame.show("viewFromWorld", scene.viewFromWorld);
    frame.count("lights drawn", double(reaching.size()));
    gpu.meshes.follow(scene);
    gpu.shadows.resize(scene.lights.size());
    gpu.remade = 0;

    // Draw the maps that have changed, each in a framebuffer of its own
    glEnable(GL_DEPTH_TEST);
    if (byMaps) {
        for (const std::size_t i : reaching) drawMap(gpu, s, scene, i);
        frame.bindTarget();
    }

    // Draw the scene without any light, and fill the depth buffer
    drawUnlit(gpu, s, scene);

    // Add the lights to it, one after the other
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (const std::size_t i : reaching) {
        if (byMaps)
            addByMap(gpu, scene, i);
        else
            addByVolumes(gpu, s, scene, i);
    }
}

void drawUnlit(Gpu& gpu, const Settings& s, const Scene& scene) {
    const Program& program = gpu.program;
    program.use();
    program.set("share", 1.0 / double(scene.lights.size()));
    program.set("firstLight", scene.lights[0].position);
    program.set("reach", s.reach);
    program.set("byMap", s.method == Method::maps);
    program.set("map", 0);
    program.set("ambientPass", true);
    program.set("light", vec4(0));
    program.set("lightColor", vec3(0));
    program.set("hasShade", false);
    gpu.noMap.bind(0, DepthLookup::compareNearest);
    drawObjects(gpu, scene, mat4(1));
    program.set("ambientPass", false);
}

// Add a light where its map shows nothing nearer to the light.
void addByMap(Gpu& gpu, const Scene& scene, std::size_t i) {
    gpu.program.use();
    gpu.program.set("hasShade", scene.lights[i].aim.has_value());
    gpu.shadows[i].map.bind(0, DepthLookup::compareNearest);
    addLight(gpu, scene, i);
}

// Add a light where the stencil buffer counts none of its volumes.
void addByVolumes(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t i) {
    glEnable(GL_STENCIL_TEST);
    countVolumes(gpu, s, scene, i);
    glStencilFunc(GL_EQUAL, 0, ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gpu.program.use();
    addLight(gpu, scene, i);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
}

// Draw the scene again, in this light alone. The depths are those of the first pass, so visible surfaces have equal ones.
void addLight(Gpu& gpu, const Scene& scene, std::size_t i) {
    gpu.program.set("light", scene.lights[i].position);
    gpu.program.set("lightColor", scene.lights[i].color);
    glDepthFunc(GL_EQUAL);
    drawObjects(gpu, scene, gpu.shadows[i].view.mapFromWorld());
    glDepthFunc(GL_LESS);
}

void drawObjects(Gpu& gpu, const Scene& scene, const mat4& mapFromWorld) {
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        gpu.program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
        gpu.program.set("worldFromObject", object.worldFromObject);
        gpu.program.set("worldFromNormal", normalMatrix(object.worldFromObject));
        gpu.program.set("mapFromObject", mapFromWorld * object.worldFromObject);
        gpu.program.set("color", object.color);
        mesh.draw();
    }
}

// Clear the count of the light before, and count this light's volumes by z-fail, as in shadow-volume.
void countVolumes(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t i) {
    CasterVolumes& volumes = gpu.shadows[i].volumes;
    if (!s.keep) volumes.forget();
    if (volumes.follow(scene, scene.lights[i].position)) ++gpu.remade;
    glClear(GL_STENCIL_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gpu.plain.use();
    countByZFail(volumes, scene, gpu.plain);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Draw a light's map, unless the light and the casters stand where they stood.
void drawMap(Gpu& gpu, const Settings& s, const Scene& scene, std::size_t i) {
    Shadow& shadow = gpu.shadows[i];
    shadow.view = viewOf(scene, scene.lights[i]);
    const bool isStale = shadow.mapFor.changed(s.resolution, shadow.view.clipFromWorld(), casterPlaces(scene));
    if (!isStale && s.keep) return;
    ++gpu.remade;

    shadow.map.begin(s.resolution, "map of light " + std::to_string(i));
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);  // by two texels of its slope, so that no surface shades itself
    gpu.plain.use();
    for (const auto& [object, mesh] : gpu.meshes.castersOf(scene)) {
        gpu.plain.set("clipFromObject", shadow.view.clipFromWorld() * object.worldFromObject);
        mesh.draw();
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

// The map of a lamp covers its shade's opening, that of any other light all casters.
LightView viewOf(const Scene& scene, const SceneLight& light) {
    if (!light.aim) return fitLightView(light.position, casterPoints(scene));
    const vec3 at(light.position);
    LightView view{.viewFromWorld = lookAtAnyRoll(at, at + *light.aim)};
    view.bounds = frustumBounds(116, 1, 0.02, 20);
    view.clipFromView = frustum(view.bounds);
    return view;
}

// Leave out each light that reaches nothing in the picture: it costs no pass.
std::vector<std::size_t> lightsThatReach(const Settings& s, const Scene& scene) {
    std::vector<std::size_t> reaching;
    const mat4 clipFromWorld = withDepths(scene.clipFromView, 0.5, 20) * scene.viewFromWorld;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (canReach(scene, clipFromWorld, vec3(scene.lights[i].position), s.reach)) reaching.push_back(i);
    }
    return reaching;
}

}  // namespace mv::shadow_lights
