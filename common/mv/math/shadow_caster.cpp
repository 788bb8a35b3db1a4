#include "mv/math/shadow_caster.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/shadow.h"

namespace mv {
namespace {

struct Extent {
    double least = HUGE_VAL, most = -HUGE_VAL;
};

// The caster's least and largest distance inside a half space; what may be rounding is 0.
Extent extentIn(const vec4& halfSpace, std::span<const vec3> corners) {
    Extent extent;
    for (const vec3& corner : corners) {
        requireFinite("judgeCaster", "each corner", corner);
        const vec4 terms = halfSpace * vec4(corner, 1);
        const vec4 sizes = glm::abs(terms);
        double inside = terms.x + terms.y + terms.z + terms.w;
        if (std::abs(inside) <= 1e-12 * (sizes.x + sizes.y + sizes.z + sizes.w)) inside = 0;
        extent = {std::min(extent.least, inside), std::max(extent.most, inside)};
    }
    return extent;
}

}  // namespace

CasterVerdict judgeCaster(std::string_view name, std::span<const vec3> corners, const vec4& light, const vec4& floor) {
    if (corners.empty()) throw Error("judgeCaster", "the caster must have a corner", "none");
    const std::string caster(name);
    const int side = lightSide(light, floor);
    if (side == 0) return {false, "The light lies in the floor: there is no shadow."};
    if (side < 0) return {false, "The light is below the floor: no shadow falls on its upper side."};

    // A light above turns no plane round, so [0] is the height above the floor and [1] the depth below the light. Each
    // point satisfies one of the two; so where neither is missed by all, some part lies between floor and light.
    const auto bounds = shadowCasterBounds(light, floor);
    const Extent aboveFloor = extentIn(bounds[0], corners), belowLight = extentIn(bounds[1], corners);
    if (aboveFloor.most <= 0) return {false, "The " + caster + " is not above the floor: no shadow of it falls there."};
    if (belowLight.most <= 0 && belowLight.least == 0) {
        return {false, "The " + caster + " is as high as the light: its shadow would lie at infinity."};
    }
    if (belowLight.most <= 0) {
        return {false, "The light is below the " + caster + ": it casts no shadow on the floor."};
    }
    if (belowLight.least > 0 && aboveFloor.least >= 0) return {true, ""};
    if (aboveFloor.least >= 0) return {true, "Only the part of the " + caster + " below the light casts a shadow."};
    if (belowLight.least > 0) return {true, "Only the part of the " + caster + " above the floor casts a shadow."};
    return {true, "Only the part of the " + caster + " between floor and light casts a shadow."};
}

}  // namespace mv
