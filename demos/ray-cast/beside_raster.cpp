// A probe of ray-cast: which object each pixel's ray meets, beside OpenGL's raster of the same scene.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "exact_rays.h"
#include "mv/demo/lesson.h"
#include "mv/image/picture.h"

namespace mv::ray_cast {
namespace {

// The objects that the demo's rays see, by its own form: 0 for the sky.
std::vector<int> seenByRays(const Settings& s) {
    const CastWay way{s.form, PlaneForm::implicit, s.starts};
    std::vector<std::size_t> kinds;
    for (std::size_t k = 0; k < castKindNames.size(); ++k) {
        if (isShown(s, k)) kinds.push_back(k);
    }
    std::vector<int> seen;
    for (int pixel = 0; pixel < s.rows * s.rows; ++pixel) {
        const LongRay ray = exactRay(s, pixel % s.rows, pixel / s.rows);
        std::optional<double> first;
        int what = 0;
        for (const std::size_t k : kinds) {
            const auto kind = static_cast<CastKind>(k);
            const auto hit = s.precision == Precision::single
                                 ? castAt(kind, s.size, RayOf<float>{fvec3(ray.origin), fvec3(ray.direction)}, way)
                                 : castAt(kind, s.size, Ray{vec3(ray.origin), vec3(ray.direction)}, way);
            if (!hit || (first && *first <= hit->t)) continue;
            first = hit->t;
            what = static_cast<int>(k) + 1;
        }
        seen.push_back(what);
    }
    return seen;
}

// Beside GL's raster of the same scene: pixels with another object, away from edges, and the part that is at edges.
std::vector<double> besideRaster(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (s.objects == only(CastKind::teapot)) return {};
    const int side = s.rows;
    const std::vector<float> raster = probing.measured(side, side);
    if (raster.empty()) return {};
    const std::vector<int> rays = seenByRays(s);
    const auto idOf = [&](std::size_t pixel) { return std::max(0, static_cast<int>(raster[pixel])); };
    double wrong = 0, edge = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const std::size_t here = pixelIndex(x, y, side);
            bool isAtEdge = false;
            for (int v = std::max(0, y - 1); v <= std::min(side - 1, y + 1); ++v) {
                for (int u = std::max(0, x - 1); u <= std::min(side - 1, x + 1); ++u)
                    isAtEdge = isAtEdge || rays[pixelIndex(u, v, side)] != rays[here];
            }
            edge += isAtEdge ? 1 : 0;
            wrong += !isAtEdge && idOf(here) != rays[here] ? 1 : 0;
        }
    }
    return {wrong, 100 * edge / (double(side) * side)};
}

const bool probed =
    addProbes("ray-cast",
              {{.numbers = {{"raster-wrong", "pixels, away from edges, where GL's triangles show another object", "px"},
                            {"at-edges", "of the pixels, that have a neighbour with another object", "%"}},
                .measure = besideRaster}});

}  // namespace
}  // namespace mv::ray_cast
