// The readouts of shadow.
#include <cmath>
#include <vector>

#include "mv/math/clip.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "shadow.h"

namespace mv::shadow {

// The area of the shadow of what lies between plane and light.
static double shadowArea(const std::vector<vec4>& outline, const vec4& light) {
    const mat4 shadowFromWorld = shadowProjection(light, planeOfShadow);
    std::vector<vec3> shadow;
    for (const vec4& corner : clipPolygon(outline, shadowCasterBounds(light, planeOfShadow))) {
        const vec4 cast = shadowFromWorld * corner;
        shadow.push_back(vec3(cast) / cast.w);
    }
    return polygonArea(shadow);
}

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    const vec4 light = lightOf(s, frame);
    const auto corners = cornersOf(worldFromModelOf(s));
    std::vector<vec4> outline;
    double highest = -HUGE_VAL;
    for (const vec3& corner : corners) {
        outline.emplace_back(corner, 1);
        highest = std::fmax(highest, corner.y);
    }
    const double leastW = s.lightHeight - highest;  // row 4 of the matrix is (0, -1, 0, light-height)
    numbers.set("least-w", leastW);

    // Measure no shadow that is not there, or that reaches to infinity
    const bool casts = judgeCaster("square", corners, light, planeOfShadow).casts;
    if (casts && leastW > 1e-12) numbers.set("shadow-area", shadowArea(outline, light));
}

}  // namespace mv::shadow
