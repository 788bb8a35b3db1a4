#include "floor_texture.h"

#include <cmath>
#include <cstdint>
#include <glm/matrix.hpp>

#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// 0..1, the same for the same n. Source: Steele, Lea, Flood, SplitMix (2014).
double scattered(int n) {
    std::uint64_t z = static_cast<std::uint64_t>(n + 1) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

// Two courses of two bricks, the upper one moved by half a brick.
vec3 brickAt(double u, double v) {
    constexpr double mortar = 0.04;  // of the repeat
    const int course = v < 0.5 ? 0 : 1;
    const double along = 2 * u + 0.5 * course, within = along - std::floor(along), up = 2 * v - course;
    if (within < 2 * mortar || up < 2 * mortar) return {0.72, 0.7, 0.66};
    const int brick = 2 * course + static_cast<int>(std::floor(along)) % 2;
    return vec3(0.36, 0.075, 0.04) * (0.6 + 0.8 * scattered(brick));
}

vec3 patternAt(FloorPattern pattern, double u, double v) {
    if (pattern == FloorPattern::bricks) return brickAt(u, v);
    if (pattern == FloorPattern::stripes) return vec3(u < 0.5 ? 0 : 1);
    return vec3((u < 0.5) == (v < 0.5) ? 0 : 1);
}

}  // namespace

FloatPicture floorPattern(FloorPattern pattern, int size) {
    constexpr int points = 4;
    FloatPicture picture(size, size, 4);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            vec3 sum(0);
            for (int j = 0; j < points; ++j) {
                for (int i = 0; i < points; ++i)
                    sum += patternAt(pattern, (x + (i + 0.5) / points) / size, (y + (j + 0.5) / points) / size);
            }
            float* const texel = &picture.values[4 * pixelIndex(x, y, size)];
            for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(sum[c] / (points * points));
            texel[3] = 1;
        }
    }
    return picture;
}

double luminance(const float* texel) {
    return 0.2126 * double(texel[0]) + 0.7152 * double(texel[1]) + 0.0722 * double(texel[2]);
}

FloorCamera floorCamera(double aspect) {
    return {rotateX(16) * translate(0, -1, 0), perspective(60, aspect, 0.1, 2000)};
}

mat3 repeatsFromPixel(int width, int height, double turn) {
    const FloorCamera camera = floorCamera(double(width) / height);
    const mat4 clipFromFloor = camera.clipFromView * camera.viewFromWorld * rotateY(turn);
    // The floor's point (u, v) is (u, 0, -v) there; depth is left out
    const auto column = [](const vec4& clip) { return vec3(clip.x, clip.y, clip.w); };
    const mat3 clipFromRepeats(column(clipFromFloor[0]), -column(clipFromFloor[2]), column(clipFromFloor[3]));
    const mat3 clipFromPixel(vec3(2.0 / width, 0, 0), vec3(0, 2.0 / height, 0), vec3(-1, -1, 1));
    return glm::inverse(clipFromRepeats) * clipFromPixel;
}

Footprint footprintOf(const mat3& repeatsFromPixel, const vec2& pixel) {
    const vec3 at = repeatsFromPixel * vec3(pixel, 1);
    const vec2 middle = vec2(at) / at.z;
    // (a / c)' = (a' - (a / c) c') / c
    const auto along = [&](int i) { return (vec2(repeatsFromPixel[i]) - middle * repeatsFromPixel[i].z) / at.z; };
    return {middle, along(0), along(1)};
}

}  // namespace mv
