#include "mv/geometry/lamp.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/sampling.h"

namespace mv {
namespace {

vec3 middleOf(const char* subject, const SceneLight& lamp) {
    requireFinite(subject, "the lamp's position", lamp.position);
    if (!(lamp.position.w > 0)) throw Error(subject, "the lamp must be near (w > 0)", vectorText(lamp.position));
    return vec3(lamp.position) / lamp.position.w;
}

void requireLevel(const char* name, const vec3& direction) {
    requireFinite("penumbraOf", name, direction);
    // 1e-9 of its length: more than the rounding of a few matrices
    if (std::abs(direction.y) > 1e-9 * glm::length(direction)) {
        throw Error("penumbraOf", std::string(name) + " must be level (y = 0)", vectorText(direction));
    }
}

}  // namespace

std::vector<vec3> lampPoints(const SceneLight& lamp, int side, std::uint32_t seed) {
    const vec3 middle = middleOf("lampPoints", lamp);
    std::vector<vec3> points;
    for (const vec2& at : jitteredSquare(side, seed)) {
        points.push_back(middle + (2 * at.x - 1) * lamp.halfU + (2 * at.y - 1) * lamp.halfV);
    }
    return points;
}

Penumbra penumbraOf(const SceneLight& lamp, const vec3& edge, const vec3& outwards) {
    const vec3 middle = middleOf("penumbraOf", lamp);
    requireLevel("the lamp's half side", lamp.halfU);
    requireLevel("the lamp's half side", lamp.halfV);
    requireLevel("the way outwards", outwards);
    requireFinite("penumbraOf", "the edge", edge);
    if (std::abs(glm::length(outwards) - 1) > 1e-9) {
        throw Error("penumbraOf", "the way outwards must have length 1", vectorText(outwards));
    }
    if (!(edge.y >= 0 && edge.y < middle.y)) {
        throw Error("penumbraOf", "the edge must be above the floor and below the lamp", vectorText(edge));
    }
    const double ratio = edge.y / (middle.y - edge.y);
    const double extent = 2 * (std::abs(glm::dot(outwards, lamp.halfU)) + std::abs(glm::dot(outwards, lamp.halfV)));
    return {edge + ratio * (edge - middle), outwards, extent * ratio};
}

}  // namespace mv
