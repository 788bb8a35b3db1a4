// The readouts of shadow-floor.
#include <vector>

#include "mv/math/clip.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "shadow-floor.h"

namespace mv::shadow_floor {

// The corners of the whole shadow, before the division by w.
static std::vector<vec4> shadowOutline(const mat4& shadowFromWorld) {
    std::vector<vec4> outline;
    outline.reserve(corners.size());
    for (const vec3& corner : corners) outline.push_back(shadowFromWorld * vec4(corner, 1));
    return outline;
}

static double areaOf(const std::vector<vec4>& homogeneous) {
    std::vector<vec3> outline;
    outline.reserve(homogeneous.size());
    for (const vec4& corner : homogeneous) outline.push_back(vec3(corner) / corner.w);
    return polygonArea(outline);
}

double areaOnFloor(const mat4& shadowFromWorld) {
    // Cut at |x| <= half w and |z| <= half w, before the division
    constexpr double half = floorSide / 2;
    const std::array<vec4, 4> edges{vec4(1, 0, 0, half), vec4(-1, 0, 0, half), vec4(0, 0, 1, half),
                                    vec4(0, 0, -1, half)};
    return areaOf(clipPolygon(shadowOutline(shadowFromWorld), edges));
}

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    const vec4 light(lightOf(s, frame), 1);
    if (!judgeCaster("square", corners, light, planeOfShadow).casts) return;
    const mat4 shadowFromWorld = shadowProjection(light, planeOfShadow);
    numbers.set("shadow-area", areaOf(shadowOutline(shadowFromWorld)));
    numbers.set("on-floor", areaOnFloor(shadowFromWorld));
}

}  // namespace mv::shadow_floor
