// The texture of the floor and its mipmaps, made by the program: light or encoded values are averaged.
#include <array>
#include <glm/common.hpp>

#include "mv/image/mipmap.h"
#include "mv/math/color.h"
#include "shared/own_picture.h"
#include "texture-filter.h"

namespace mv::texture_filter {

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

}  // namespace mv::texture_filter
