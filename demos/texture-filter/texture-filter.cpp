// texture-filter: a floor to the horizon, whose pixels cover parts of a texel near the eye and thousands far away.
#include "texture-filter.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "mv/gl/gl.h"
#include "mv/image/mipmap.h"
#include "mv/math/color.h"
#include "mv/math/transform.h"
#include "shared/own_picture.h"

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
        gpu.image.filterBy({.minify = minifying(s.filter),
                            .magnify = magnifying(s.filter),
                            .wrap = GL_REPEAT,
                            .anisotropy = looks(s)});
    } else {
        gpu.image.bind(0);
    }
}

// GL_TEXTURE_MIN_FILTER: where a pixel covers many texels, between texels and between levels.
GLenum minifying(Filter filter) {
    constexpr std::array<GLenum, 6> names{GL_NEAREST,
                                          GL_LINEAR,
                                          GL_NEAREST_MIPMAP_NEAREST,
                                          GL_LINEAR_MIPMAP_NEAREST,
                                          GL_LINEAR_MIPMAP_LINEAR,
                                          GL_LINEAR_MIPMAP_LINEAR};
    return names.at(static_cast<std::size_t>(filter));
}
// GL_TEXTURE_MAG_FILTER: where a texel covers many pixels, between texels alone.
GLenum magnifying(Filter filter) {
    return filter == Filter::nearest || filter == Filter::nearestMipNearest ? GL_NEAREST : GL_LINEAR;
}
bool isMipmapped(const Settings& s) { return s.filter >= Filter::nearestMipNearest; }
int looks(const Settings& s) {
    return s.filter == Filter::anisotropic ? std::min(s.anisotropy, largestAnisotropy()) : 1;
}

// Turn light into the encoded values of sRGB. Averages are of light, or of encoded values.
static void encode(FloatPicture& picture) {
    for (float& value : picture.values) value = static_cast<float>(srgbFromLinear(double(value)));
}
static void tint(FloatPicture& picture, const vec3& color) {
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        if (i % 4 == 3) continue;
        picture.values[i] = static_cast<float>(glm::mix(double(picture.values[i]), color[int(i % 4)], 0.7));
    }
}

// The picture and its levels, each half as wide and high as the one before.
std::vector<FloatPicture> levelsOf(const Settings& s) {
    FloatPicture first =
        s.picture.isSet() ? ownTexels(*s.picture.content(), s.size, s.size) : floorPattern(s.pattern, s.size);
    if (s.average == Average::encoded) encode(first);
    std::vector<FloatPicture> levels{first};
    if (isMipmapped(s) && !isByDriver(s)) levels = mipmaps(first);

    const std::array<vec3, 8> colors{vec3(0.9, 0.2, 0.2), vec3(0.95, 0.6, 0.1), vec3(0.9, 0.9, 0.2),
                                     vec3(0.2, 0.7, 0.2), vec3(0.1, 0.7, 0.8),  vec3(0.2, 0.3, 0.9),
                                     vec3(0.6, 0.2, 0.8), vec3(0.5, 0.5, 0.5)};
    for (std::size_t i = 1; areColored(s) && i < levels.size(); ++i) tint(levels[i], colors.at((i - 1) % 8));
    if (formatOf(s) == Texels::srgb) {
        for (FloatPicture& level : levels) encode(level);
    }
    return levels;
}
bool areColored(const Settings& s) { return isMipmapped(s) && s.showLevels; }
// The driver draws into the levels that it makes.
bool isByDriver(const Settings& s) { return isMipmapped(s) && !areColored(s) && s.mipmapsBy == MadeBy::driver; }
Texels formatOf(const Settings& s) {
    if (s.texels == Kept::floats) return filteredFloats();
    return s.average == Average::linear ? Texels::srgb : Texels::bytes;
}

}  // namespace mv::texture_filter
