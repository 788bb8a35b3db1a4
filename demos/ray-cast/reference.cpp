// What the study of ray-cast compares with: each pixel's t in long double, and of the teapot by another structure.
#include <cmath>
#include <optional>
#include <vector>

#include "exact_rays.h"
#include "mv/demo/lesson.h"
#include "ray-cast.h"

namespace mv::ray_cast {

bool isShown(const Demo& demo, std::size_t kind) {
    if (demo.word("objects") == "all") return kind < castTogether;
    return demo.word("objects") == castKindNames.at(kind);
}

// The teapot's triangles, by the grid, which shares no box with the tree.
Reference teapotReference(const Demo& demo) {
    const int side = static_cast<int>(demo.number("rows"));
    const int cells = static_cast<int>(std::lround(std::sqrt(demo.number("triangles") / 64)));
    const auto grid = findTriangles(RayStructure::grid, teapotTriangles(cells));
    const double size = demo.number("scale");
    Reference reference;
    for (int pixel = 0; pixel < side * side; ++pixel) {
        const LongRay ray = exactRay(demo, pixel % side, pixel / side, side);
        const auto hit = grid->nearest({vec3(ray.origin) / size, vec3(ray.direction) / size});
        reference.values.push_back(hit ? hit->hit.t / size - demo.number("distance") : 10);
    }
    reference.work = double(reference.values.size());
    return reference;
}

// Each pixel's t as the demo's values() has it, and what is there.
Reference longDouble(const Demo& demo) {
    const int side = static_cast<int>(demo.number("rows"));
    const bool isFloat = demo.word("precision") == "float";
    const Long size = static_cast<Long>(demo.number("scale"));
    Reference reference;
    reference.across = side;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const LongRay ray = exactRay(demo, i, j, side);
            std::optional<Long> first;
            int seen = 0;
            for (std::size_t k = 0; k < castKindNames.size(); ++k) {
                if (!isShown(demo, k)) continue;
                const auto t = exactHit(ray, static_cast<CastKind>(k), size, isFloat);
                if (!t || (first && *first <= *t)) continue;
                first = t;
                seen = static_cast<int>(k) + 1;
            }
            reference.values.push_back(
                first ? static_cast<double>(*first / size - static_cast<Long>(demo.number("distance"))) : 10);
            reference.regions.push_back(seen);
        }
    }
    reference.work = double(reference.values.size());
    return reference;
}

}  // namespace mv::ray_cast
