#include "shared/light_rays.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "mv/geometry/check.h"
#include "mv/geometry/ray.h"

namespace mv {
namespace {

constexpr double beginsBefore = 3;  // a corner, of a light at infinity
const vec4 color(0.95, 0.55, 0, 1);

}  // namespace

std::vector<vec3> cornersOf(const MeshData& mesh, const mat4& worldFromModel) {
    const std::vector<std::uint32_t> first = weldByPosition(mesh.positions);
    std::vector<vec3> corners;
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) continue;
        if (corners.size() == 8) return {};
        corners.emplace_back(worldFromModel * vec4(mesh.positions[i], 1));
    }
    return corners;
}

void drawLightRays(Drawing& drawing, const mat4& clipFromWorld, const vec4& light, std::span<const vec3> corners,
                   std::span<const vec4> planes) {
    for (const vec3& corner : corners) {
        const vec3 away = light.w * corner - vec3(light);  // from the light
        if (away == vec3(0)) continue;
        std::optional<double> nearest;
        for (const vec4& plane : planes) {
            const auto met = intersectPlane(Ray{corner, away}, plane);
            if (met && (!nearest || *met < *nearest)) nearest = met;
        }
        const vec3 from = light.w == 0 ? corner - beginsBefore * glm::normalize(away) : vec3(light) / light.w;
        drawing.edge(clipFromWorld, from, corner + nearest.value_or(0) * away, {.color = color, .width = 3});
    }
    if (light.w != 0) drawing.point(clipFromWorld, vec3(light) / light.w, 17, color);
}

void drawSceneRays(Drawing& drawing, const Scene& scene, const Frame& frame) {
    std::vector<vec4> planes;
    for (const SceneObject& object : scene.objects) {
        const vec3 normal(object.worldFromObject[1]), point(object.worldFromObject[3]);
        if (!object.casts) planes.emplace_back(glm::normalize(normal), -glm::dot(glm::normalize(normal), point));
    }
    drawing.begin(frame);
    for (const SceneObject& object : scene.objects) {
        if (!object.casts) continue;
        drawLightRays(drawing, scene.clipFromWorld(), scene.lights.front().position,
                      cornersOf(object.mesh, object.worldFromObject), planes);
    }
    drawing.draw(frame);
}

}  // namespace mv
