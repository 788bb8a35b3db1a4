#include "shared/relief_rays.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"

namespace mv {
namespace {

constexpr double near = 5e-5;  // units above the surface that count as on it

// How far a point is above the displaced surface, along the normal of the smooth one.
double gapAt(const Relief& relief, const vec3& point) {
    const double up = relief.body == ReliefBody::wall ? point.z : glm::length(point) - 1;
    return up + relief.depth * (1 - reliefHeight(relief, point));
}

// Marches from `start` up to `end`, both along the line, while the gap is above 0. The gap shrinks
// at most `fastest` times as fast as the line goes on.
std::optional<ReliefPoint> march(const Relief& relief, const vec3& from, const vec3& way, double start, double end,
                                 double fastest) {
    double t = start;
    while (t <= end) {
        const double gap = gapAt(relief, from + t * way);
        if (gap <= near) return reliefAt(relief, from + t * way);
        t += gap / fastest;
    }
    return {};
}

}  // namespace

std::optional<ReliefPoint> firstHit(const Relief& relief, const vec3& from, const vec3& way) {
    if (relief.body == ReliefBody::wall) {
        if (!(way.z < 0)) throw Error("firstHit", "the line must run towards the wall", numberText(way.z));
        const double start = -from.z / way.z;
        const double sideways = std::hypot(way.x, way.y);
        const double fastest = -way.z + relief.depth * steepest(relief.body) * sideways;
        // At the relief's depth the gap is 0 or less: so the last of the march is beyond it by a rounding.
        return march(relief, from, way, start, start + (relief.depth + 2 * near) / -way.z + near, fastest);
    }
    const double along = -glm::dot(from, way), square = glm::dot(from, from) - along * along;
    if (square >= 1) return {};
    const double half = std::sqrt(1 - square), least = 1 - relief.depth;
    return march(relief, from, way, along - half, along + half, 1 + relief.depth * steepest(relief.body) / least);
}

}  // namespace mv
