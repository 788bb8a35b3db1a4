#include "mv/geometry/edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "mv/error.h"
#include "mv/geometry/check.h"

namespace mv {

MeshData edgesOf(const MeshData& mesh, double crease) {
    if (!(crease >= 0 && crease <= 180)) throw Error("edgesOf", "crease must be 0 .. 180 deg", numberText(crease));
    const double leastCosine = std::cos(radians(crease));
    const auto triangles = trianglesOf(mesh);
    const std::vector<std::uint32_t> first = weldByPosition(mesh.positions);

    // The unit normals of the faces at each edge
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<vec3>> normalsAt;
    for (const auto& triangle : triangles) {
        const vec3 a(mesh.positions[triangle[0]]), b(mesh.positions[triangle[1]]), c(mesh.positions[triangle[2]]);
        const vec3 normal = glm::cross(b - a, c - a);
        if (glm::length(normal) == 0) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto ends = std::minmax({first[triangle[i]], first[triangle[(i + 1) % 3]]});
            normalsAt[ends].push_back(glm::normalize(normal));
        }
    }

    MeshData edges;
    edges.primitive = Primitive::lines;
    for (const auto& [ends, normalsThere] : normalsAt) {
        const auto& normals = normalsThere;  // a lambda may name it in clang before 16, too
        const bool sharp = std::any_of(normals.begin(), normals.end(), [&](const vec3& normal) {
            return glm::dot(normal, normals.front()) < leastCosine;
        });
        if (normals.size() > 1 && !sharp) continue;
        for (const std::uint32_t end : {ends.first, ends.second}) edges.positions.push_back(mesh.positions[end]);
    }
    return edges;
}

}  // namespace mv
