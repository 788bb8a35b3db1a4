// mirror: a plane mirror, and two that face each other, by the stencil buffer or by a texture.
#include "mirror.h"

#include <cmath>
#include <glm/matrix.hpp>

#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"

namespace mv::mirror {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Sight sight = sightOf(s, frame);
    const vec2 size(frame.width(), frame.height());
    gpu.meshes.follow(sight.scene);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    if (s.method == Method::texture) drawTextures(gpu, s, sight, frame);  // texture.cpp

    // Draw the world itself, and the mirrors in it. Each mirror marks its pixels in the stencil buffer
    drawWorld(gpu, s, sight, viewAfter(s, sight, 0, 0), 1);
    if (s.method == Method::stencil) glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (std::size_t chain = 0; chain < sight.chains.size(); ++chain) {
        glStencilFunc(GL_ALWAYS, 1 + 128 * static_cast<int>(chain), ~0U);
        drawMirror(gpu, s, sight, chain, 0, size);
    }
    if (s.method == Method::stencil) drawWhereMarked(gpu, s, sight, size);
    tell(s, sight, frame);
}

// Draw one bounce: the reflected world, where the mark shows that the mirror is seen. Two mirrors may be seen beside each
// other, so their marks differ by 128.
static void drawBounce(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce,
                       const vec2& size) {
    glStencilFunc(GL_EQUAL, bounce + 128 * static_cast<int>(chain), ~0U);

    // 1. Reset all depths of the mirror to the farthest
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    glDepthRange(1, 1);
    drawMirror(gpu, s, sight, chain, bounce - 1, size);
    glDepthRange(0, 1);
    glDepthFunc(GL_LESS);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

    // 2. Draw the world after this many reflections. Each of them leaves a part of the light
    drawWorld(gpu, s, sight, viewAfter(s, sight, chain, bounce), std::pow(s.reflectance, bounce));

    // 3. Draw the other mirror in that world, which increments the mark
    if (bounce == sight.length(chain)) return;
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    drawMirror(gpu, s, sight, chain, bounce, size);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}
void drawWhereMarked(Gpu& gpu, const Settings& s, const Sight& sight, const vec2& size) {
    gpu.work = {};
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (int bounce = 1; bounce <= s.bounces; ++bounce) {
        for (std::size_t chain = 0; chain < sight.chains.size(); ++chain) {
            if (bounce <= sight.length(chain)) drawBounce(gpu, s, sight, chain, bounce, size);
        }
    }
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
    if (clips) glEnable(GL_CLIP_DISTANCE0);
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
    if (clips) glDisable(GL_CLIP_DISTANCE0);
}

// Draw a mirror of the chain as it is seen after `bounce` reflections: with its texture, or empty.
void drawMirror(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce, const vec2& size) {
    const Mirror& mirror = sight.mirrors[sight.chains[chain][static_cast<std::size_t>(bounce)].which];
    const bool hasTexture = s.method == Method::texture && bounce < s.bounces;
    const Program& surface = hasTexture ? *gpu.textured : *gpu.plain;
    surface.use();
    if (hasTexture) {
        textureOf(gpu, chain, bounce + 1).bindColor(0);
        surface.set("lookup", vec3(1.0 / size, s.reflectance));
    } else {
        surface.set("sky", std::pow(s.reflectance, s.method == Method::texture ? 1 : bounce + 1) * sky);
    }
    // Move the unit square of the plane y = 0 onto the mirror
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
