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

long trianglesOfSquare(double inner, double outer) { return trianglesOfSquare(inner, {outer, outer, outer, outer}); }

long trianglesOfSquare(double inner, const std::array<double, 4>& outer) {
    long around = 0;
    for (const double level : {inner, outer[0], outer[1], outer[2], outer[3]}) {
        if (!(level >= 1 && level <= largestLevel))
            throw Error("trianglesOfSquare", "must have levels in 1 .. 64", numberText(level));
    }
    for (const double level : outer) around += static_cast<long>(std::ceil(level));
    auto within = static_cast<long>(std::ceil(inner));
    if (within == 1 && around == 4) return 2;
    within = std::max(within, 2L);
    // A square of cells, and round it a ring: on each side a row of triangles between the outer pieces and the inner ones
    return 2 * (within - 2) * (within - 2) + around + 4 * (within - 2);
}

}  // namespace mv
