#include "mv/geometry/tangent_frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

vec3 longest(const std::array<vec3, 3>& edges) {
    return *std::max_element(edges.begin(), edges.end(),
                             [](const vec3& a, const vec3& b) { return glm::dot(a, a) < glm::dot(b, b); });
}

}  // namespace

TangentFrame tangentFrame(const std::array<vec3, 3>& points, const std::array<vec2, 3>& texCoords) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (!isFinite(points.at(i)) || !isFinite(vec3(texCoords.at(i), 0)))
            throw Error("tangentFrame", "needs points and texture coordinates that are finite");
    }
    const vec3 first = points[1] - points[0], second = points[2] - points[0], across = accurateCross(first, second);
    if (across == vec3(0)) throw Error("tangentFrame", "needs a triangle with an area");
    const vec3 normal = unit(across);
    const vec2 a = texCoords[1] - texCoords[0], b = texCoords[2] - texCoords[0];
    const double inTexture = differenceOfProducts(a.x, b.y, b.x, a.y);
    // Along it u grows and v stays: its factor is the sign of the area in the texture, not one by that area.
    const double sign = inTexture < 0 ? -1 : 1;
    vec3 along = inTexture == 0 ? a.x * glm::cross(second, normal) + b.x * glm::cross(normal, first)
                                : sign * (b.y * first - a.y * second);
    if (along == vec3(0)) along = longest({first, second, points[2] - points[1]});
    const vec3 scaled = unit(along);
    const vec3 tangent = unit(scaled - glm::dot(scaled, normal) * normal);
    return {tangent, sign * glm::cross(normal, tangent), normal, sign};
}

vec3 shadingNormal(const std::array<vec3, 3>& normals, const vec3& weights, const vec3& face) {
    const vec3 sum = weights.x * normals[0] + weights.y * normals[1] + weights.z * normals[2];
    const double size = std::abs(weights.x) + std::abs(weights.y) + std::abs(weights.z);
    return glm::length(sum) > 1e-15 * size ? unit(sum) : face;
}

float repeatedCoordinate(double coordinate) {
    if (!std::isfinite(coordinate)) throw Error("repeatedCoordinate", "must be finite", numberText(coordinate));
    const auto rest = static_cast<float>(coordinate - std::floor(coordinate));
    return rest < 1 ? rest : 0;  // just below a whole number, rounded up to it
}

}  // namespace mv
