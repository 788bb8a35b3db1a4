#include "ball_texture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "mv/image/mipmap.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// Columns go on round the ball; rows end at the poles.
vec3 texel(const FloatPicture& level, long column, long row) {
    const long x = ((column % level.width) + level.width) % level.width, y = std::clamp(row, 0L, level.height - 1L);
    const auto at = static_cast<std::size_t>(3 * (y * level.width + x));
    return {level.values[at], level.values[at + 1], level.values[at + 2]};
}

vec3 between(const FloatPicture& level, const vec2& at) {
    const vec2 place = at * vec2(level.width, level.height) - 0.5, low = glm::floor(place), part = place - low;
    const long x = std::lround(low.x), y = std::lround(low.y);
    return glm::mix(glm::mix(texel(level, x, y), texel(level, x + 1, y), part.x),
                    glm::mix(texel(level, x, y + 1), texel(level, x + 1, y + 1), part.x), part.y);
}

std::vector<FloatPicture> globeLevels() {
    constexpr int width = 512, height = 256, squares = 24;  // round the ball
    FloatPicture picture(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int column = x * squares / width, row = y * squares / 2 / height;
            const double hue = 2 * pi * column / squares;
            const vec3 dark = 0.28 + 0.22 * vec3(std::cos(hue), std::cos(hue - 2 * pi / 3), std::cos(hue + 2 * pi / 3));
            vec3 color = (column + row) % 2 == 0 ? vec3(0.85, 0.82, 0.72) : dark;
            if (std::abs(y - height / 2) <= 1 || std::abs(x - width / 2) <= 1) color = {0.75, 0.1, 0.05};
            for (int channel = 0; channel < 3; ++channel)
                picture.values[static_cast<std::size_t>(3 * (y * width + x) + channel)] = float(color[channel]);
        }
    }
    return mipmaps(picture);
}

}  // namespace

vec2 onTexture(const vec3& normalInModel) {
    const vec3& n = normalInModel;
    const double u = n.x == 0 && n.z == 0 ? 0.5 : 0.5 - std::atan2(n.z, n.x) / (2 * pi);
    return {u, 0.5 + std::asin(std::clamp(n.y, -1.0, 1.0)) / pi};
}

vec3 textureAround(const BallTexture& texture, const vec3& normal, double width) {
    const vec2 at = onTexture(texture.modelFromWorld * normal);
    const FloatPicture& finest = texture.levels->front();
    if (width == 0)
        return texel(finest, std::lround(std::floor(at.x * finest.width)),
                     std::lround(std::floor(at.y * finest.height)));
    // From pole to pole is pi radii
    const double texels = std::max(1.0, width / pi * finest.height), last = double(texture.levels->size()) - 1;
    const double level = std::min(std::log2(texels), last), low = std::floor(level);
    const auto finer = static_cast<std::size_t>(low), coarser = std::min(finer + 1, texture.levels->size() - 1);
    return glm::mix(between(texture.levels->at(finer), at), between(texture.levels->at(coarser), at), level - low);
}

BallTexture globeTexture(double turn) {
    static const auto levels = std::make_shared<const std::vector<FloatPicture>>(globeLevels());
    return {levels, glm::transpose(mat3(rotateZ(-23.4) * rotateY(turn)))};
}

}  // namespace mv
