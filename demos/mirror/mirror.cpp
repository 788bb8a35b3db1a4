// mirror: a plane mirror, and two that face each other, by the stencil buffer or by a texture.
#include "mirror.h"

#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/gl/state.h"

namespace mv::mirror {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofMethod{drawByStencil, drawByTexture};  // in the order of Method; texture.cpp
    const Sight sight = sightOf(s, frame);
    gpu.meshes.follow(sight.scene);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    ofMethod.at(std::size_t(s.method))(gpu, s, sight, frame);
    tell(s, sight, frame);
}

void drawByStencil(Gpu& gpu, const Settings& s, const Sight& sight, const Frame&) {
    // Draw the world itself, and the mirrors in it. Each mirror marks its pixels in the stencil buffer
    drawWorld(gpu, s, sight, viewAfter(s, sight, 0, 0), 1);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (std::size_t chain = 0; chain < sight.chains.size(); ++chain) {
        glStencilFunc(GL_ALWAYS, 1 + 128 * static_cast<int>(chain), ~0U);
        drawEmpty(gpu, s, sight, chain, 0, s.reflectance);
    }

    // Draw bounce after bounce where the marks are
    gpu.work = {};
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (int bounce = 1; bounce <= s.bounces; ++bounce) {
        for (std::size_t chain = 0; chain < sight.chains.size(); ++chain) {
            if (bounce <= sight.length(chain)) drawBounce(gpu, s, sight, chain, bounce);
        }
    }
}

// Draw one bounce: the reflected world, where the mark shows that the mirror is seen. Two mirrors may be seen beside each
// other, so their marks differ by 128.
void drawBounce(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce) {
    glStencilFunc(GL_EQUAL, bounce + 128 * static_cast<int>(chain), ~0U);

    // 1. Reset all depths of the mirror to the farthest
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    glDepthRange(1, 1);
    drawEmpty(gpu, s, sight, chain, bounce - 1, 0);
    glDepthRange(0, 1);
    glDepthFunc(GL_LESS);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

    // 2. Draw the world after this many reflections. Each of them leaves a part of the light
    drawWorld(gpu, s, sight, viewAfter(s, sight, chain, bounce), std::pow(s.reflectance, bounce));

    // 3. Draw the other mirror in that world, which increments the mark
    if (bounce == sight.length(chain)) return;
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    drawEmpty(gpu, s, sight, chain, bounce, std::pow(s.reflectance, bounce + 1));
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

// Each reflection reverses the winding of all faces.
static void setFront(const Settings& s, int bounce) { glFrontFace(s.winding && bounce % 2 == 1 ? GL_CW : GL_CCW); }

// Draw the world without the mirrors, in a `part` of its light.
void drawWorld(Gpu& gpu, const Settings& s, const Sight& sight, const View& view, double part) {
    const bool clips = view.bounce > 0 && s.near == Near::clipDistance;
    gpu.world.use();
    gpu.world.set("light", sight.scene.lights.front().position);
    gpu.world.set("part", part);
    if (!isEs()) {
        gpu.world.set("clips", clips);
        gpu.world.set("beforeMirror", view.before);
    }
    setEnabled(GL_CLIP_DISTANCE0, clips);
    setFront(s, view.bounce);
    const auto all = gpu.meshes.of(sight.scene);
    for (const std::size_t i : shownIn(gpu, s, sight, view)) {
        const auto& [object, mesh] = all[i];
        gpu.world.set("worldFromObject", object.worldFromObject);
        gpu.world.set("color", object.color);
        gpu.world.set("number", double(i + 1));
        gpu.world.set("clipFromObject", view.clipFromWorld * object.worldFromObject);
        mesh.draw();
    }
    switchOff(GL_CLIP_DISTANCE0);
}

// Draw a mirror before anything is seen in it: a `part` of the sky's light.
void drawEmpty(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce, double part) {
    gpu.plain->use();
    gpu.plain->set("sky", part * sky);
    drawMirror(gpu, *gpu.plain, s, sight, chain, bounce);
}

// Draw a mirror of the chain as it is seen after `bounce` reflections: move the unit square of the plane y = 0 onto it.
void drawMirror(Gpu& gpu, const Program& surface, const Settings& s, const Sight& sight, std::size_t chain,
                int bounce) {
    const Mirror& mirror = sight.mirrors[sight.chains[chain][static_cast<std::size_t>(bounce)].which];
    const mat4 worldFromSquare(vec4(2.0 * mirror.halfU, 0), vec4(vec3(mirror.plane()), 0), vec4(-2.0 * mirror.halfV, 0),
                               vec4(mirror.middle, 1));
    surface.set("clipFromSquare", viewAfter(s, sight, chain, bounce).clipFromWorld * worldFromSquare);
    setFront(s, bounce);
    gpu.rectangle.draw();
}

// The view after `bounce` reflections. The oblique near plane lies in the last mirror.
View viewAfter(const Settings& s, const Sight& sight, std::size_t chain, int bounce) {
    if (bounce == 0) return {.clipFromWorld = sight.scene.clipFromWorld(), .edges = edgesOfView()};
    const SeenMirror& last = sight.chains[chain][static_cast<std::size_t>(bounce - 1)];
    const vec4 plane = sight.mirrors[last.which].plane();
    const mat4 viewFromShown = sight.scene.viewFromWorld * last.worldFromShown;
    mat4 clipFromView = sight.scene.clipFromView;
    if (s.near == Near::oblique)
        clipFromView = withNearPlane(clipFromView, planeIn(glm::inverse(viewFromShown), plane));
    return {bounce, clipFromView * viewFromShown, last.edges, plane, MirrorRoom::frameOf(last.which)};
}

}  // namespace mv::mirror
