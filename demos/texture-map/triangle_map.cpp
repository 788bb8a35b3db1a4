#include "triangle_map.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/error.h"

namespace mv {

mat3 pointFromTexture(const TexturedTriangle& triangle) {
    const auto& [p, t] = triangle;
    const mat3 corners(vec3(t[0], 1), vec3(t[1], 1), vec3(t[2], 1));
    if (glm::determinant(corners) == 0)
        throw Error("pointFromTexture", "needs texture coordinates that are not on a line");
    return mat3(p[0], p[1], p[2]) * glm::inverse(corners);
}

PlaneMap mapByMatrix(const TexturedTriangle& triangle) {
    const mat3 p = pointFromTexture(triangle);
    if (glm::determinant(p) == 0) throw Error("mapByMatrix", "needs a plane that does not hold the origin");
    return {.linear = glm::inverse(p)};
}

PlaneMap mapByEdges(const TexturedTriangle& triangle) {
    const auto& [p, t] = triangle;
    const vec3 first = p[1] - p[0], second = p[2] - p[0], normal = glm::cross(first, second);
    const double square = glm::dot(normal, normal);
    if (!(square > 0)) throw Error("mapByEdges", "needs a triangle with an area");
    // 1 along one edge, and 0 along the other: a point's barycentric coordinates
    const vec3 alongFirst = glm::cross(second, normal) / square, alongSecond = glm::cross(normal, first) / square;
    const vec2 change1 = t[1] - t[0], change2 = t[2] - t[0];
    const vec3 u = change1.x * alongFirst + change2.x * alongSecond,
               v = change1.y * alongFirst + change2.y * alongSecond;
    return {glm::transpose(mat3(u, v, vec3(0))), p[0], t[0]};
}

double errorInFloats(const PlaneMap& map, const TexturedTriangle& triangle) {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const fvec3 way = fmat3(map.linear) * (fvec3(triangle.points.at(i)) - fvec3(map.corner));
        largest = std::max(largest, glm::distance(vec2(fvec2(way) + fvec2(map.atCorner)), triangle.texture.at(i)));
    }
    return largest;
}

}  // namespace mv
