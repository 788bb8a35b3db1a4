// texture-filter: a floor to the horizon, whose pixels cover parts of a texel near the eye and thousands far away.
#include "texture-filter.h"

#include <algorithm>
#include <array>

#include "mv/gl/gl.h"
#include "mv/math/transform.h"

namespace mv::texture_filter {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    bindTexture(gpu, s);

    // Draw the floor. The driver looks up each pixel's footprint, or the shader looks up several places along it
    const Pane pane = paneOf(frame);
    glViewport(pane.x, pane.y, pane.width, pane.height);
    const auto drawFiltered = looks(s) > 1 ? drawAlong : drawByDriver;
    drawFiltered(gpu, s, floorCamera(pane.aspect()));
    tell(s, frame);
}

void drawByDriver(Gpu& gpu, const Settings& s, const FloorCamera& camera) {
    gpu.program->use();
    drawFloor(gpu, *gpu.program, s, camera);
}
void drawAlong(Gpu& gpu, const Settings& s, const FloorCamera& camera) {
    gpu.alongProgram->use();
    gpu.alongProgram->set("looks", looks(s));
    drawFloor(gpu, *gpu.alongProgram, s, camera);
}
void drawFloor(Gpu& gpu, const Program& program, const Settings& s, const FloorCamera& camera) {
    program.set("clipFromFloor", camera.clipFromView * camera.viewFromWorld * rotateY(s.turn));
    program.set("bias", s.bias);
    program.set("encoded", s.average == Average::encoded);
    gpu.floor.draw();
}

// Upload the texture, with its levels where the filter reads them, and set its filter: between texels, between levels, and
// along the footprint.
void bindTexture(Gpu& gpu, const Settings& s) {
    Texture& image = gpu.image.of(
        {s.pattern, s.picture.version(), s.size, s.average, formatOf(s), isMipmapped(s), isByDriver(s), areColored(s)},
        [&] {
            return Texture(levelsOf(s), {.texels = formatOf(s), .driverMipmaps = isByDriver(s), .label = "floor"});
        });
    const GlFilter filter = glFilter(s.filter);
    image.filterBy({.minify = filter.minify, .magnify = filter.magnify, .wrap = GL_REPEAT, .anisotropy = looks(s)});
}

// GL_TEXTURE_MIN_FILTER: where a pixel covers many texels, between texels and between levels. GL_TEXTURE_MAG_FILTER: where a texel
// covers many pixels, between texels alone.
GlFilter glFilter(Filter filter) {
    constexpr std::array<GlFilter, 6> filters{{{GL_NEAREST, GL_NEAREST},
                                               {GL_LINEAR, GL_LINEAR},
                                               {GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST},
                                               {GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR},
                                               {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR},
                                               {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR}}};  // in the order of Filter
    return filters.at(static_cast<std::size_t>(filter));
}
bool isMipmapped(const Settings& s) { return s.filter >= Filter::nearestMipNearest; }
int looks(const Settings& s) {
    return s.filter == Filter::anisotropic ? std::min(s.anisotropy, largestAnisotropy()) : 1;
}

bool areColored(const Settings& s) { return isMipmapped(s) && s.showLevels; }
// Coloured levels are the program's own.
bool isByDriver(const Settings& s) { return isMipmapped(s) && !areColored(s) && s.mipmapsBy == MadeBy::driver; }
Texels formatOf(const Settings& s) {
    if (s.texels == Kept::floats) return filteredFloats();
    return s.average == Average::linear ? Texels::srgb : Texels::bytes;
}

}  // namespace mv::texture_filter
