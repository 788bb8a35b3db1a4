#include "mv/math/clip.h"

#include <glm/geometric.hpp>
#include <utility>

#include "mv/math/require.h"

namespace mv {
namespace {

// Where the segment from a point inside to one outside leaves the half space: always computed in this direction, so
// that the same segment walked the other way gives the same bits.
vec4 crossing(const vec4& inside, const vec4& outside, const vec4& halfSpace) {
    const double in = glm::dot(halfSpace, inside), out = glm::dot(halfSpace, outside);
    return inside + (in / (in - out)) * (outside - inside);
}

}  // namespace

std::vector<vec4> clipPolygon(std::vector<vec4> polygon, std::span<const vec4> halfSpaces) {
    for (const vec4& corner : polygon) requireFinite("clipPolygon", "each corner", corner);
    for (const vec4& halfSpace : halfSpaces) {
        requireFinite("clipPolygon", "each half space", halfSpace);
        std::vector<vec4> kept;
        const auto keep = [&](const vec4& corner) {
            if (kept.empty() || kept.back() != corner) kept.push_back(corner);
        };
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const vec4 &corner = polygon[i], &next = polygon[(i + 1) % polygon.size()];
            const bool in = glm::dot(halfSpace, corner) >= 0, nextIn = glm::dot(halfSpace, next) >= 0;
            if (in) keep(corner);
            if (in != nextIn) keep(in ? crossing(corner, next, halfSpace) : crossing(next, corner, halfSpace));
        }
        if (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
        polygon = std::move(kept);
    }
    return polygon;
}

const std::array<vec4, 6>& clipVolume() {
    static const std::array<vec4, 6> planes{vec4(1, 0, 0, 1),  vec4(-1, 0, 0, 1), vec4(0, 1, 0, 1),
                                            vec4(0, -1, 0, 1), vec4(0, 0, 1, 1),  vec4(0, 0, -1, 1)};
    return planes;
}

double polygonArea(std::span<const vec3> corners) {
    for (const vec3& corner : corners) requireFinite("polygonArea", "each corner", corner);
    vec3 sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    return glm::length(sum) / 2;
}

}  // namespace mv
