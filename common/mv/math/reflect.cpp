#include "mv/math/reflect.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"

namespace mv {

vec3 reflected(const vec3& way, const vec3& normal) { return way - normal * glm::dot(normal, way) * 2.0; }

std::optional<vec3> refracted(const vec3& way, const vec3& normal, double index) {
    if (!(index > 0 && index <= 1e150))
        throw Error("refracted", "the index must be above 0, up to 1e150", numberText(index));
    const double cosine = -glm::dot(way, normal), square = (index - 1) * (index + 1) + cosine * cosine;
    if (square < 0) return {};
    return way / index + normal * ((cosine - std::sqrt(square)) / index);
}

}  // namespace mv
