// shadow-map: a depth buffer seen from the light. Points farther away than its depth are in shadow.
#include "shadow-map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/demo/seen.h"
#include "mv/error.h"
#include "mv/gl/functions.h"
#include "mv/gl/state.h"
#include "mv/math/transform.h"

namespace mv::shadow_map {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    const LightView light = lightView(s, scene);
    gpu.meshes.follow(scene);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);

    // Redraw the map when the light, the scene or a setting of the map has changed
    const bool isStale = gpu.mapFor.changed(light.clipFromWorld(), s.scene, s.sides, s.cord, s.resolution, s.mapFaces,
                                            s.receiver, s.slopeBias);
    if (isStale || !s.keep) {
        drawMap(gpu, s, scene, light);
        frame.bindTarget();
    }
    constexpr std::array ofSlide{drawPicture, drawSlide, drawSlide};  // in the order of Slide; slide.cpp
    ofSlide.at(std::size_t(s.slide))(gpu, s, scene, light);
    tell(s, scene, light, frame);
}

// Pass 1: draw the scene as the light sees it, and keep only the depths.
void drawMap(Gpu& gpu, const Settings& s, const Scene& scene, const LightView& light) {
    gpu.map.begin(s.resolution, "shadow map");
    glClear(GL_DEPTH_BUFFER_BIT);

    // Draw half of the faces, those towards the light or those away from it, or both
    setEnabled(GL_CULL_FACE, s.mapFaces != Faces::both);
    glCullFace(culledFor(s.mapFaces));
    // Push each triangle back by slopeBias times its change of depth over a texel, and by 2 * slopeBias depth steps
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(float(s.slopeBias), float(2 * s.slopeBias));

    gpu.depthProgram.use();
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        if (!s.receiver && !object.casts) continue;
        gpu.depthProgram.set("mapClipFromObject", light.clipFromWorld() * object.worldFromObject);
        mesh.draw();
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glCullFace(GL_BACK);
    glEnable(GL_CULL_FACE);
}

GLenum culledFor(Faces inMap) {
    constexpr std::array<GLenum, 3> culled{GL_BACK, GL_FRONT, GL_BACK};  // in the order of Faces
    return culled.at(std::size_t(inMap));
}

// The cosines of the cone's outer limit, and of its inner limit 10 degrees within. Without a cone all points are inside both.
static vec2 spotCosines(const Settings& s) {
    if (s.rays != Rays::spot || s.frustum != Fit::set) return {-3, -2};
    return {std::cos(radians(s.fov / 2)), std::cos(radians(std::max(0.0, s.fov / 2 - 10)))};
}

// Pass 2: draw the scene as the eye sees it. The shader looks each point up in the map.
void drawPicture(Gpu& gpu, const Settings& s, const Scene& scene, const LightView& light) {
    const Program& program = *gpu.program;
    program.use();
    setLookup(gpu, s, program);
    program.set("eye", vec3(glm::inverse(scene.viewFromWorld)[3]));
    program.set("spotAxis", glm::normalize(s.target - s.light));
    program.set("spotCosines", spotCosines(s));
    drawObjects(gpu, program, scene, light);
}

// Tell the shader what it compares: the map in unit 1, the bias, and the light.
void setLookup(Gpu& gpu, const Settings& s, const Program& program) {
    gpu.map.bind(1, lookupOf(s.filter));
    program.set("map", 1);
    program.set("taps", looksAlong(s.filter));
    program.set("bias", s.bias);
    program.set("light", lightOf(s));
    program.set("checkered", s.scene == Which::sphereAndCube);
}

// Draw each object with its places in the eye's picture and on the map.
void drawObjects(Gpu& gpu, const Program& program, const Scene& scene, const LightView& light) {
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
        program.set("mapFromObject", light.mapFromWorld() * object.worldFromObject);
        program.set("worldFromObject", object.worldFromObject);
        program.set("color", object.color);
        mesh.draw();
    }
}

// Every filter but Filter::none mixes the answers of four texels at each lookup. A square of lookups has looksAlong() on a side.
DepthLookup lookupOf(Filter filter) {
    constexpr auto nearest = DepthLookup::compareNearest, linear = DepthLookup::compareLinear;
    constexpr std::array lookups{nearest, linear, linear, linear, linear};  // in the order of Filter
    return lookups.at(std::size_t(filter));
}
int looksAlong(Filter filter) {
    constexpr std::array looks{1, 1, 3, 5, 7};
    return looks.at(std::size_t(filter));
}

// The light's own camera. The map holds what this camera sees.
LightView lightView(const Settings& s, const Scene& scene) {
    constexpr std::array ofRays{spotView, parallelView};  // in the order of Rays
    if (s.frustum == Fit::set) return ofRays.at(std::size_t(s.rays))(s);
    try {
        return fitLightView(lightOf(s), casterPoints(scene));
    } catch (const Error&) {
        throw Error("--light-y", "must keep the light clear of what casts, for a fitted frustum",
                    numberText(s.light.y));
    }
}

// The light looks from its place to its target, within a cone or along parallel rays.
static mat4 gazeOf(const Settings& s) {
    const vec3 gaze = s.target - s.light;
    const bool vertical = std::hypot(gaze.x, gaze.z) < 1e-9 * std::abs(gaze.y);
    return lookAt(s.light, s.target, vertical ? vec3(0, 0, -1) : vec3(0, 1, 0));
}
constexpr double near = 0.5, far = 10;
LightView spotView(const Settings& s) {
    const FrustumBounds bounds = frustumBounds(s.fov, s.windowWidth / s.windowHeight, near, far);
    return {.viewFromWorld = gazeOf(s), .clipFromView = mv::frustum(bounds), .bounds = bounds};
}
LightView parallelView(const Settings& s) {
    const double x = s.windowWidth / 2, y = s.windowHeight / 2;
    return {.viewFromWorld = gazeOf(s),
            .clipFromView = ortho(-x, x, -y, y, near, far),
            .bounds = {-x, x, -y, y, near, far},
            .atInfinity = true};
}

// A point, or the direction towards parallel light.
vec4 lightOf(const Settings& s) { return s.rays == Rays::spot ? vec4(s.light, 1) : vec4(s.light - s.target, 0); }

}  // namespace mv::shadow_map
