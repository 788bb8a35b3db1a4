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
    const FloorCamera camera = floorCamera(pane.aspect());
    const Program& program = looks(s) > 1 ? *gpu.alongProgram : *gpu.program;
    program.use();
    program.set("clipFromFloor", camera.clipFromView * camera.viewFromWorld * rotateY(s.turn));
    program.set("bias", isMipmapped(s) ? s.bias : 0);
    program.set("encoded", s.average == Average::encoded);
    if (looks(s) > 1) program.set("looks", looks(s));
    gpu.floor.draw();
    tell(s, frame);
}

// Upload the texture, with its levels where the filter reads them, and set its filter: between texels, between levels, and
// along the footprint.
void bindTexture(Gpu& gpu, const Settings& s) {
    if (gpu.imageFor.changed(s.pattern, s.picture.version(), s.size, s.average, formatOf(s), isMipmapped(s),
                             isByDriver(s), areColored(s))) {
        gpu.image = Texture(levelsOf(s), {.texels = formatOf(s), .driverMipmaps = isByDriver(s), .label = "floor"});
        gpu.filterFor.forget();
    }
    if (gpu.filterFor.changed(s.filter, looks(s))) {
        const auto [minify, magnify] = glFilters(s.filter);
        gpu.image.filterBy({.minify = minify, .magnify = magnify, .wrap = GL_REPEAT, .anisotropy = looks(s)});
    } else {
        gpu.image.bind(0);
    }
}

// GL_TEXTURE_MIN_FILTER: where a pixel covers many texels, between texels and between levels. GL_TEXTURE_MAG_FILTER: where a texel
// covers many pixels, between texels alone.
GlFilters glFilters(Filter filter) {
    constexpr std::array<GlFilters, 6> filters{{{GL_NEAREST, GL_NEAREST},
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
// The driver draws into the levels that it makes.
bool isByDriver(const Settings& s) { return isMipmapped(s) && !areColored(s) && s.mipmapsBy == MadeBy::driver; }
Texels formatOf(const Settings& s) {
    if (s.texels == Kept::floats) return filteredFloats();
    return s.average == Average::linear ? Texels::srgb : Texels::bytes;
}

}  // namespace mv::texture_filter
