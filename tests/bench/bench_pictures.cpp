#include "bench/bench_pictures.h"

#include <algorithm>
#include <cmath>

#include "mv/math/types.h"

namespace mv::bench {
namespace {

std::uint8_t level(double value) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0))); }

Pixel colour(const vec3& c) { return {level(c.x), level(c.y), level(c.z), 255}; }

// The colour that a ray from the eye, which is in the origin and looks along -z, sees in the direction (x, y, -1).
vec3 seen(double x, double y) {
    const vec3 light(0.48, 0.6, 0.64);
    const vec3 centre(0, 0, -4);
    const double radius = 1.3;

    // |t * direction - centre|^2 = radius^2, the smaller root
    const vec3 direction(x, y, -1);
    const double a = direction.x * direction.x + direction.y * direction.y + 1;
    const double b = -4 * direction.z;
    const double discriminant = b * b - a * (16 - radius * radius);
    if (discriminant >= 0) {
        const double t = (b - std::sqrt(discriminant)) / a;
        const vec3 normal = (t * direction - centre) / radius;
        const double lambert = std::max(0.0, normal.x * light.x + normal.y * light.y + normal.z * light.z);
        const double shine = std::pow(lambert, 40.0);
        return (0.15 + 0.75 * lambert) * vec3(0.9, 0.35, 0.2) + 0.5 * shine;
    }
    if (y < -0.05) {
        const double t = -1.3 / y;
        const auto square = std::llround(t * x) + std::llround(t);
        const double fog = std::exp(-0.06 * t);
        return fog * (square % 2 == 0 ? vec3(0.85, 0.85, 0.8) : vec3(0.25, 0.3, 0.4)) + (1 - fog) * vec3(0.7, 0.8, 0.9);
    }
    return vec3(0.7, 0.8, 0.9) + (y + 0.05 + 0.1 * x) * vec3(-0.5, -0.35, -0.05);
}

}  // namespace

Picture renderedLike(int width, int height) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            picture.set(x, y, colour(seen((x + 0.5 - width / 2.0) / height, (height / 2.0 - y - 0.5) / height)));
    }
    return picture;
}

Picture flatCube(int side) {
    Picture picture(side, side);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            // A cube seen along its diagonal is a hexagon; u, v, w are the distances along its three axes.
            const double x = (i + 0.5) / side - 0.5;
            const double y = 0.5 - (j + 0.5) / side;
            const double across = x / std::sqrt(3.0);
            const double u = y;
            const double v = across * 1.5 - y / 2;
            const double w = -across * 1.5 - y / 2;
            const double extent = 0.36;
            Pixel pixel{255, 255, 255, 255};
            if (std::max({u, v, w}) - std::min({u, v, w}) < extent) {
                if (u <= std::min(v, w))
                    pixel = {0, 0, 255, 255};
                else if (v <= w)
                    pixel = {255, 0, 0, 255};
                else
                    pixel = {0, 255, 0, 255};
            }
            picture.set(i, j, pixel);
        }
    }
    return picture;
}

}  // namespace mv::bench
