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

// The caster's least and largest distance inside a half space; what may be rounding is 0. `lastSize` is that of the terms
// whose sum halfSpace.w is, which may have cancelled.
Extent extentIn(const vec4& halfSpace, double lastSize, std::span<const vec3> corners) {
    Extent extent;
    for (const vec3& corner : corners) {
        requireFinite("judgeCaster", "each corner", corner);
        const vec4 terms = halfSpace * vec4(corner, 1);
        const vec4 sizes = glm::abs(terms);
        double inside = terms.x + terms.y + terms.z + terms.w;
        const double size = sizes.x + sizes.y + sizes.z + lastSize;
        if (!std::isfinite(size)) {
            throw Error("judgeCaster", "light and corners must not be so large that a height overflows",
                        vectorText(corner));
        }
        if (std::abs(inside) <= 1e-12 * size) inside = 0;
        extent = {std::min(extent.least, inside), std::max(extent.most, inside)};
    }
    return extent;
}

// A sentence with each @ replaced by the caster's name.
std::string about(std::string_view caster, std::string_view sentence) {
    std::string text;
    for (const char c : sentence) c == '@' ? text += caster : text += c;
    return text;
}

struct Sentences {
    const char *lightInPlane, *lightBehind, *casterBehind, *levelWithLight, *beyondLight;
    const char *partBelowLight, *partAbovePlane, *partBetween;
};

constexpr Sentences ofFloor{
    .lightInPlane = "The light lies in the floor: there is no shadow.",
    .lightBehind = "The light is below the floor: no shadow falls on its upper side.",
    .casterBehind = "The @ is not above the floor: no shadow of it falls there.",
    .levelWithLight = "The @ is as high as the light: its shadow would lie at infinity.",
    .beyondLight = "The light is below the @: it casts no shadow on the floor.",
    .partBelowLight = "Only the part of the @ below the light casts a shadow.",
    .partAbovePlane = "Only the part of the @ above the floor casts a shadow.",
    .partBetween = "Only the part of the @ between floor and light casts a shadow.",
};
constexpr Sentences ofWall{
    .lightInPlane = "The light lies in the plane of the wall: no shadow falls there.",
    .lightBehind = "The light is behind the wall: no shadow falls on its front.",
    .casterBehind = "The @ is not in front of the wall: no shadow of it falls there.",
    .levelWithLight = "The @ is as far from the wall as the light: its shadow would lie at infinity.",
    .beyondLight = "The light is nearer to the wall than the @: it casts no shadow there.",
    .partBelowLight = "Only the part of the @ nearer to the wall than the light casts a shadow there.",
    .partAbovePlane = "Only the part of the @ in front of the wall casts a shadow there.",
    .partBetween = "Only the part of the @ between wall and light casts a shadow there.",
};

}  // namespace

CasterVerdict judgeCaster(std::string_view name, std::span<const vec3> corners, const vec4& light, const vec4& floor,
                          PlaneKind kind) {
    if (corners.empty()) throw Error("judgeCaster", "the caster must have a corner", "none");
    const Sentences& say = kind == PlaneKind::floor ? ofFloor : ofWall;
    const int side = lightSide(light, floor);
    if (side == 0) return {false, say.lightInPlane};
    if (side < 0) return {false, say.lightBehind};

    // A light above turns no plane round, so [0] is the height above the floor and [1] the depth below the light. Each
    // point satisfies one of the two; so where neither is missed by all, some part lies between floor and light.
    const auto bounds = shadowCasterBounds(light, floor);
    const double heightTerms = glm::dot(glm::abs(vec3(bounds[0])), glm::abs(vec3(light)));
    const Extent aboveFloor = extentIn(bounds[0], std::abs(bounds[0].w), corners);
    const Extent belowLight = extentIn(bounds[1], heightTerms, corners);
    if (aboveFloor.most <= 0) return {false, about(name, say.casterBehind)};
    if (belowLight.most <= 0) {
        return {false, about(name, belowLight.least == 0 ? say.levelWithLight : say.beyondLight)};
    }
    if (belowLight.least > 0 && aboveFloor.least >= 0) return {true, ""};
    if (aboveFloor.least >= 0) return {true, about(name, say.partBelowLight)};
    if (belowLight.least > 0) return {true, about(name, say.partAbovePlane)};
    return {true, about(name, say.partBetween)};
}

}  // namespace mv
