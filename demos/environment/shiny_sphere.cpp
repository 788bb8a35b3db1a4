#include "shiny_sphere.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/math/color.h"
#include "mv/math/reflect.h"

namespace mv {

std::optional<vec3> ShinySphere::seenAlong(const Ray& ray) const {
    const auto within = intersectSphere(ray, vec3(0), 1.0);
    if (!within || within->near < 0) return {};
    const vec3 n = glm::normalize(ray.at(within->near)), way = glm::normalize(ray.direction);
    const double cosine = std::clamp(-glm::dot(n, way), 0.0, 1.0);
    const vec3 mirrored = room.seenAlong({n, way + 2 * cosine * n});
    const vec3 part = coating.reflected(cosine);
    vec3 light = part * mirrored;
    if (coating.kind != Coating::Kind::glass) return light;
    const double reflected = part.x;
    const auto into = refracted(way, n, coating.index);
    if (reflected < 1 && into) light += through(*into, n, reflected);
    return light;
}

// Inside the sphere, light meets the surface at the same angle each time, so each time the same part is reflected.
vec3 ShinySphere::through(const vec3& into, const vec3& normal, double reflected) const {
    vec3 light(0), way = into, from = normal;
    double part = 1 - reflected;
    for (int i = 0; i <= innerReflections && part > 1e-6; ++i) {
        const vec3 end = glm::normalize(from - 2 * glm::dot(from, way) * way);
        const auto out = refracted(way, -end, 1 / coating.index);
        if (!out) break;  // rounding, at the very edge of total reflection
        light += part * (1 - reflected) * room.seenAlong({end, *out});
        part *= reflected;
        way = mv::reflected(way, end);
        from = end;
    }
    return light;
}

std::vector<double> ShinySphere::picture(const Scene& camera, int width, int height) const {
    const mat4 worldFromClip = glm::inverse(camera.clipFromWorld());
    const vec3 eye(glm::inverse(camera.viewFromWorld)[3]);
    std::vector<double> values;
    values.reserve(std::size_t(width) * std::size_t(height));
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const vec4 far = worldFromClip * vec4(2 * (column + 0.5) / width - 1, 1 - 2 * (row + 0.5) / height, 1, 1);
            const Ray ray{eye, glm::normalize(vec3(far) / far.w - eye)};
            const bool counts = glm::length(glm::cross(eye, ray.direction)) < 0.95;
            const auto light = counts ? seenAlong(ray) : std::nullopt;
            values.push_back(light ? luminance(*light) : -1);
        }
    }
    return values;
}

}  // namespace mv
