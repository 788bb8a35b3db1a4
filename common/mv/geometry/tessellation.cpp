#include "mv/geometry/tessellation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"

namespace mv {

double levelInRange(double wanted) { return wanted > 1 ? std::min(wanted, largestLevel) : 1; }

double edgeLevel(const vec3& a, const vec3& b, const vec3& eye, double fineness) {
    return levelInRange(fineness * glm::distance(a, b) / glm::distance(0.5 * (a + b), eye));
}

long trianglesOfSquare(double inner, double outer) {
    for (const double level : {inner, outer}) {
        if (!(level >= 1 && level <= largestLevel))
            throw Error("trianglesOfSquare", "must have levels in 1 .. 64", numberText(level));
    }
    const auto around = static_cast<long>(std::ceil(outer));
    auto within = static_cast<long>(std::ceil(inner));
    if (within == 1 && around == 1) return 2;
    within = std::max(within, 2L);
    // A square of cells, and round it a ring: on each side a row of triangles between the outer pieces and the inner ones
    return 2 * (within - 2) * (within - 2) + 4 * (around + within - 2);
}

}  // namespace mv
