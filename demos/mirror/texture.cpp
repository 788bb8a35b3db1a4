// Mirrors by textures: the mirrored world is drawn into a texture, which the mirror shows.
#include "mirror.h"
#include "mv/gl/gl.h"

namespace mv::mirror {

// Draw the textures, the world itself, and the mirrors in it.
void drawByTexture(Gpu& gpu, const Settings& s, const Sight& sight, const Frame& frame) {
    drawTextures(gpu, s, sight, frame);
    drawWorld(gpu, s, sight, viewAfter(s, sight, 0, 0), 1);
    for (std::size_t chain = 0; chain < sight.chains.size(); ++chain)
        drawTextured(gpu, s, sight, chain, 0, vec2(frame.width(), frame.height()));
}

// Draw from the last bounce to the first, since the world in a mirror shows the other mirror with the texture drawn before. The
// textures are kept while eye and world rest. Unlike a shadow map, they are for one eye.
void drawTextures(Gpu& gpu, const Settings& s, const Sight& sight, const Frame& frame) {
    if (sight.chains.empty()) return;
    const bool isStale = gpu.texturesFor.changed(sight.scene, s, frame.width(), frame.height(), frame.measuring());
    if (!isStale && s.keep) return;
    gpu.work = {};
    const fvec3 clear(frame.measuring() ? vec3(0.3 * (sky.x + sky.y + sky.z)) : sky);
    glClearColor(clear.x, clear.y, clear.z, 1);
    for (int bounce = s.bounces; bounce >= 1; --bounce) {
        for (std::size_t chain = 0; chain < sight.chains.size(); ++chain) {
            if (bounce <= sight.length(chain)) drawTexture(gpu, s, sight, chain, bounce, frame);
        }
    }
    frame.bindTarget();
}

// Draw the world after this many reflections, and the other mirror in it.
void drawTexture(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce, const Frame& frame) {
    const int width = (frame.width() + s.coarser - 1) / s.coarser;
    const int height = (frame.height() + s.coarser - 1) / s.coarser;
    Target& target = textureOf(gpu, chain, bounce);
    const auto format = static_cast<GLenum>(frame.measuring() ? GL_R32F : GL_RGBA8);
    target.begin(width, height, {.depth = true, .color = format, .texture = true}, "mirrored");
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawWorld(gpu, s, sight, viewAfter(s, sight, chain, bounce), 1);
    if (bounce < sight.length(chain)) drawTextured(gpu, s, sight, chain, bounce, vec2(width, height));
}

// Draw a mirror with its texture, in a picture of this size. Nothing is seen in the mirror of the last bounce.
void drawTextured(Gpu& gpu, const Settings& s, const Sight& sight, std::size_t chain, int bounce, const vec2& size) {
    if (bounce == s.bounces) return drawEmpty(gpu, s, sight, chain, bounce, s.reflectance);
    gpu.textured->use();
    textureOf(gpu, chain, bounce + 1).bindColor(0);
    gpu.textured->set("lookup", vec3(1.0 / size, s.reflectance));
    drawMirror(gpu, *gpu.textured, s, sight, chain, bounce);
}

Target& textureOf(Gpu& gpu, std::size_t chain, int bounce) {
    return gpu.textures.at(chain).at(static_cast<std::size_t>(bounce % 2));
}

}  // namespace mv::mirror
