#include "mv/math/stereo.h"

#include <algorithm>
#include <cmath>

#include "mv/math/projection.h"
#include "mv/math/require.h"

namespace mv {

std::optional<Parallax> parallaxOf(std::span<const vec3> points, const mat4& clipFromLeft, const mat4& clipFromRight,
                                   int width, int height, double leastW) {
    requirePositive("parallaxOf", "leastW", leastW);
    requireFinite("parallaxOf", "the left eye's matrix", clipFromLeft);
    requireFinite("parallaxOf", "the right eye's matrix", clipFromRight);
    std::optional<Parallax> result;
    for (const vec3& point : points) {
        requireFinite("parallaxOf", "each point", point);
        const vec4 left = clipFromLeft * vec4(point, 1), right = clipFromRight * vec4(point, 1);
        if (left.w < leastW || right.w < leastW) continue;
        const vec2 parallax =
            pixelFromNdc(ndcFromClip(right), width, height) - pixelFromNdc(ndcFromClip(left), width, height);
        if (!result) result = Parallax{parallax.x, parallax.x, 0};
        result->leastAcross = std::min(result->leastAcross, parallax.x);
        result->mostAcross = std::max(result->mostAcross, parallax.x);
        result->vertical = std::max(result->vertical, std::abs(parallax.y));
    }
    return result;
}

}  // namespace mv
