// The scenes of shadow-lights, and the bulbs that are drawn over them.
#include <algorithm>
#include <cmath>

#include "light_scenes.h"
#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/transform.h"
#include "shadow-lights.h"

namespace mv::shadow_lights {

// All lights that are placed hang at one height.
vec3 over(const vec2& place) { return {place.x, 2, place.y}; }

static Scene lit(const Settings& s, const FrameInfo& frame) {
    if (s.scene == Which::lamps) return lampsAndBall(frame.aspect(), frame.index());
    if (s.scene == Which::circle) return circleOfLights(frame.aspect(), frame.index(), s.lights);
    std::vector<vec3> at;
    for (const vec2& place : s.places) at.push_back(over(place));
    return lightsOverStillLife(frame.aspect(), at);
}

// Without a far plane, which would cut volumes off. The side of a volume is hardly apart from a surface that a light
// grazes, and the depth buffer tells them apart by steps that grow with 1/near: from where the camera stands, and from
// farther back, nothing is nearer than 2.
Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene = lit(s, frame);
    scene.viewFromWorld = seenFrom(s.orbit, scene.viewFromWorld);
    const double near = s.orbit.distance < 0 ? 0.1 : 0.5;
    scene.clipFromView = withDepths(scene.clipFromView, near, HUGE_VAL);
    return scene;
}

// The bulbs show where the lights are. The shades are no solids of the scene, so they cast nothing.
void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = seen(sceneOf(s, frame), frame);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    if (s.method == Method::volumes) glDisable(GL_STENCIL_TEST);
    gpu.plain.use();
    for (const SceneLight& light : scene.lights) {
        const double most = std::max({light.color.x, light.color.y, light.color.z});
        gpu.plain.set("color", vec4(light.color / most, 1));
        gpu.plain.set("clipFromObject", scene.clipFromWorld() * translate(vec3(light.position)));
        gpu.bulb->draw();
    }
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    numbers.set("lights-drawn", double(lightsThatReach(s, seen(sceneOf(s, frame), frame)).size()));
    numbers.set("shadows-remade", gpu.remade);
}

}  // namespace mv::shadow_lights
