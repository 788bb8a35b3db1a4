#include "mv/geometry/in_volume.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {

InVolume hullInVolume(std::span<const vec3> corners, std::span<const vec4> planes) {
    for (const vec3& corner : corners) requireFinite("hullInVolume", "a corner", corner);
    if (corners.empty()) return InVolume::outside;
    bool isCrossed = false;
    for (const vec4& plane : planes) {
        requireFinite("hullInVolume", "a plane", plane);
        const auto isOutside = [&](const vec3& corner) { return glm::dot(plane, vec4(corner, 1)) < 0; };
        const auto outside = static_cast<std::size_t>(std::ranges::count_if(corners, isOutside));
        if (outside == corners.size() && vec3(plane) != vec3(0)) return InVolume::outside;
        isCrossed = isCrossed || outside > 0;
    }
    return isCrossed ? InVolume::crossing : InVolume::inside;
}

InVolume ballInVolume(const vec3& center, double radius, std::span<const vec4> planes) {
    requireFinite("ballInVolume", "the center", center);
    requireFinite("ballInVolume", "the radius", radius);
    if (radius < 0) throw Error("ballInVolume", "the radius must be 0 or more", numberText(radius));
    bool isCrossed = false;
    for (const vec4& plane : planes) {
        requireFinite("ballInVolume", "a plane", plane);
        if (vec3(plane) == vec3(0)) continue;
        const double height = glm::dot(plane, vec4(center, 1));
        if (height < -radius) return InVolume::outside;
        isCrossed = isCrossed || height < radius;
    }
    return isCrossed ? InVolume::crossing : InVolume::inside;
}

}  // namespace mv
