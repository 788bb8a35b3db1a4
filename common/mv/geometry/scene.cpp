#include "mv/geometry/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/geometry/check.h"
#include "mv/math/projection.h"
#include "mv/math/require.h"
#include "mv/math/transform.h"

namespace mv {

std::vector<mat4> casterPlaces(const Scene& scene) {
    std::vector<mat4> places;
    for (const SceneObject& object : scene.objects) {
        if (object.casts) places.push_back(object.worldFromObject);
    }
    return places;
}

mat4 withDepths(const mat4& clipFromView, double near, double far) {
    if (clipFromView[2][3] != -1) throw Error("withDepths", "must be given a perspective");
    // Only the third row has to do with depth
    const mat4 other = std::isinf(far) ? infinitePerspective(90, 1, near) : perspective(90, 1, near, far);
    mat4 result = clipFromView;
    for (int column = 0; column < 4; ++column) result[column][2] = other[column][2];
    return result;
}

MeshData meshOf(const Scene& scene) {
    const bool normals = std::none_of(scene.objects.begin(), scene.objects.end(),
                                      [](const SceneObject& object) { return object.mesh.normals.empty(); });
    MeshData all;
    for (const SceneObject& object : scene.objects) {
        const auto triangles = trianglesOf(object.mesh);
        if (triangles.empty()) throw Error("object " + object.name, "must be made of triangles");
        const mat3 worldNormal = normals ? normalMatrix(object.worldFromObject) : mat3(1);
        for (const std::array<std::uint32_t, 3>& corners : triangles) {
            for (const std::uint32_t i : corners) {
                const vec3 position(object.worldFromObject * vec4(vec3(object.mesh.positions[i]), 1));
                requireFitsFloat("object " + object.name, "its places in the world", position);
                all.positions.emplace_back(position);
                all.colors.emplace_back(vec4(object.color, 1));
                if (normals) all.normals.emplace_back(glm::normalize(worldNormal * vec3(object.mesh.normals[i])));
            }
        }
    }
    return all;
}

}  // namespace mv
