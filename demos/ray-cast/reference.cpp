// What the study of ray-cast compares with: each pixel's t in long double, and of the teapot by another structure.
#include <cmath>
#include <optional>
#include <vector>

#include "exact_rays.h"

namespace mv::ray_cast {

bool isShown(const Settings& s, std::size_t kind) {
    if (s.objects == Objects::all) return kind < castTogether;
    return s.objects == only(static_cast<CastKind>(kind));
}

// The teapot's triangles, by the grid, which shares no box with the tree.
Reference teapotReference(const Settings& s) {
    const int cells = static_cast<int>(std::lround(std::sqrt(s.triangles / 64)));
    const auto grid = findTriangles(RayStructure::grid, teapotTriangles(cells));
    Reference reference;
    for (int pixel = 0; pixel < s.rows * s.rows; ++pixel) {
        const LongRay ray = exactRay(s, pixel % s.rows, pixel / s.rows);
        const auto hit = grid->nearest({vec3(ray.origin) / s.size, vec3(ray.direction) / s.size});
        reference.values.push_back(hit ? hit->hit.t / s.size - s.distance : 10);
    }
    reference.work = double(reference.values.size());
    return reference;
}

// Each pixel's t as the demo's values() has it, and what is there.
Reference longDouble(const Settings& s) {
    const bool isFloat = s.precision == Precision::single;
    const Long size = static_cast<Long>(s.size);
    Reference reference;
    reference.across = s.rows;
    for (int j = 0; j < s.rows; ++j) {
        for (int i = 0; i < s.rows; ++i) {
            const LongRay ray = exactRay(s, i, j);
            std::optional<Long> first;
            int seen = 0;
            for (std::size_t k = 0; k < castKindNames.size(); ++k) {
                if (!isShown(s, k)) continue;
                const auto t = exactHit(ray, static_cast<CastKind>(k), size, isFloat);
                if (!t || (first && *first <= *t)) continue;
                first = t;
                seen = static_cast<int>(k) + 1;
            }
            reference.values.push_back(first ? static_cast<double>(*first / size - static_cast<Long>(s.distance)) : 10);
            reference.regions.push_back(seen);
        }
    }
    reference.work = double(reference.values.size());
    return reference;
}

}  // namespace mv::ray_cast
