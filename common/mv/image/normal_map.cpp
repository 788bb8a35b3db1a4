#include "mv/image/normal_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>

#include "mv/error.h"

namespace mv {
namespace {

// The derivative in the middle of texel i of n, in heights a texel.
template <class Height>
double slopeAt(int i, int n, bool repeats, const Height& height) {
    if (repeats || (i > 0 && i < n - 1)) return 0.5 * (height((i + 1) % n) - height((i + n - 1) % n));
    const int step = i == 0 ? 1 : -1;  // inwards
    return 0.5 * step * (-3 * height(i) + 4 * height(i + step) - height(i + 2 * step));
}

}  // namespace

FloatPicture normalMap(const FloatPicture& heights, const HeightMapShape& shape) {
    checkPicture(heights, "normalMap");
    const int width = heights.width, height = heights.height;
    if (width < 3 || height < 3)
        throw Error("normalMap", "must have 3 texels a side at least", std::to_string(std::min(width, height)));
    if (shape.channel < 0 || shape.channel >= heights.channels)
        throw Error("normalMap", "must be made from a channel of the picture", std::to_string(shape.channel));
    if (!(shape.depth >= 0)) throw Error("normalMap depth", "must be 0 or more", numberText(shape.depth));
    const auto at = [&](int x, int y) {
        const std::size_t first = static_cast<std::size_t>(heights.channels) * pixelIndex(x, y, width);
        return double(heights.values[first + static_cast<std::size_t>(shape.channel)]);
    };
    FloatPicture normals(width, height, 4);
    for (int y = 0; y < height; ++y) {
        const vec2 texel = shape.texel(y);
        if (!(texel.x > 0 && texel.y > 0))
            throw Error("normalMap texel", "must have sides above 0", numberText(std::min(texel.x, texel.y)));
        for (int x = 0; x < width; ++x) {
            const double alongU = slopeAt(x, width, shape.repeatsU, [&](int i) { return at(i, y); }) / texel.x,
                         alongV = slopeAt(y, height, shape.repeatsV, [&](int i) { return at(x, i); }) / texel.y;
            const vec3 normal = glm::normalize(vec3(-shape.depth * alongU, -shape.depth * alongV, 1));
            float* const kept = &normals.values[4 * pixelIndex(x, y, width)];
            for (int i = 0; i < 3; ++i) kept[i] = static_cast<float>(0.5 + 0.5 * normal[i]);
            kept[3] = 1;
        }
    }
    return normals;
}

vec3 normalOf(const float* texel) {
    return glm::normalize(2.0 * vec3(double(texel[0]), double(texel[1]), double(texel[2])) - 1.0);
}

}  // namespace mv
