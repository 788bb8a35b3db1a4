#include "ray-cast/depth_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "mv/error.h"
#include "mv/image/picture.h"
#include "mv/math/require.h"
#include "shared/raster_triangle.h"

namespace mv {
namespace {

// In pixels, the lower left corner at (0, 0), with the depth as z.
vec3 inPicture(const mat4& clipFromWorld, const vec3& point, int width, int height) {
    const vec4 clip = clipFromWorld * vec4(point, 1);
    if (!(clip.w > 0)) throw Error("rasterized", "each corner must be before the eye", vectorText(point));
    return {(clip.x / clip.w + 1) / 2 * width, (clip.y / clip.w + 1) / 2 * height, clip.z / clip.w};
}

// From the first middle at or after `low` to the last before `high`, of 0 .. count - 1.
struct Span {
    int first, last;
};
Span middlesIn(double low, double high, int count) {
    return {std::max(0, static_cast<int>(std::floor(low - 0.5))),
            std::min(count - 1, static_cast<int>(std::ceil(high - 0.5)))};
}

}  // namespace

DepthRaster rasterized(std::span<const SceneTriangle> triangles, const mat4& clipFromWorld, int width, int height) {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    DepthRaster raster{std::vector<double>(pixels, 1), std::vector<int>(pixels, -1)};
    for (std::size_t number = 0; number < triangles.size(); ++number) {
        const SceneTriangle& one = triangles[number];
        const vec3 a = inPicture(clipFromWorld, one.a, width, height),
                   b = inPicture(clipFromWorld, one.b, width, height),
                   c = inPicture(clipFromWorld, one.c, width, height);
        const auto [low, high] = std::minmax({a.x, b.x, c.x});
        const auto [below, above] = std::minmax({a.y, b.y, c.y});
        const Span columns = middlesIn(low, high, width), rows = middlesIn(below, above, height);
        if (columns.first > columns.last || rows.first > rows.last) continue;
        const std::vector<EdgeFunction> edges = edgeFunctions({vec2(a), vec2(b), vec2(c)}, EdgeRule::bottomLeft);
        if (edges.empty()) continue;
        // The depth's plane: z = a.z + zx (x - a.x) + zy (y - a.y)
        const vec3 ab = b - a, ac = c - a;
        const double area = ab.x * ac.y - ab.y * ac.x;
        if (area == 0) continue;
        const double zx = (ab.z * ac.y - ab.y * ac.z) / area, zy = (ab.x * ac.z - ab.z * ac.x) / area;
        for (int y = rows.first; y <= rows.last; ++y) {
            std::array<std::int64_t, 3> values{};
            for (std::size_t k = 0; k < 3; ++k)
                values[k] = edges[k].at(columns.first * std::int64_t{subPixels} + subPixels / 2,
                                        y * std::int64_t{subPixels} + subPixels / 2);
            for (int x = columns.first; x <= columns.last; ++x) {
                bool isIn = true;
                for (std::size_t k = 0; k < 3; ++k) {
                    isIn = isIn && (values[k] > 0 || (values[k] == 0 && edges[k].keeps));
                    values[k] += edges[k].a * subPixels;
                }
                if (!isIn) continue;
                const double depth = a.z + zx * (x + 0.5 - a.x) + zy * (y + 0.5 - a.y);
                const std::size_t pixel = pixelIndex(x, height - 1 - y, width);
                if (depth >= raster.depth[pixel]) continue;
                raster.depth[pixel] = depth;
                raster.triangle[pixel] = static_cast<int>(number);
            }
        }
    }
    return raster;
}

}  // namespace mv
