#include "perspective_quad.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "mv/error.h"

namespace mv {

mat4 clipFromQuad(double ratio) {
    constexpr double halfWidth = 0.9, low = -0.85, high = 0.75;  // of the picture, from -1 to 1
    return {{2 * halfWidth, 0, 0, 0}, {0, ratio * high - low, 0, ratio - 1}, {0, 0, 1, 0}, {-halfWidth, low, 0, 1}};
}

mat3 pixelFromQuad(double ratio, const Pane& pane) {
    const mat4 clip = clipFromQuad(ratio);
    const auto rows = [](const vec4& column) { return vec3(column.x, column.y, column.w); };
    const mat3 clipFromPlane(rows(clip[0]), rows(clip[1]), rows(clip[3]));
    const mat3 pixelFromClip(vec3(0.5 * pane.width, 0, 0), vec3(0, 0.5 * pane.height, 0),
                             vec3(pane.x + 0.5 * pane.width, pane.y + 0.5 * pane.height, 1));
    return pixelFromClip * clipFromPlane;
}

mat3 quadFromPixel(double ratio, const Pane& pane) { return glm::inverse(pixelFromQuad(ratio, pane)); }

vec2 projected(const mat3& map, const vec2& place) {
    const vec3 at = map * vec3(place, 1);
    return vec2(at) / at.z;
}

Slip largestSlip(double ratio, int n, const Pane& pane) {
    if (n < 1) throw Error("largestSlip", "needs a cell a side at least", std::to_string(n));
    if (!(ratio >= 1)) throw Error("largestSlip", "needs a ratio of 1 at least", numberText(ratio));
    const mat3 map = pixelFromQuad(ratio, pane);
    const double root = std::sqrt(1 + (ratio - 1) / n), part = (root - 1) / (root + 1);
    Slip largest;
    const auto ask = [&](const vec2& near, const vec2& far) {
        const vec2 from = projected(map, near), to = projected(map, far);
        const double pixels = part * glm::distance(from, to);
        if (pixels <= largest.pixels) return;
        // The texture's point at the part s of the way is shown there, and belongs at s r / (1 + s (r - 1)).
        const double shown = 1 / (1 + root), right = root / (1 + root);
        largest = {pixels, glm::mix(from, to, shown), glm::mix(from, to, right)};
    };
    const double side = 1.0 / n;
    for (int i = 0; i < n; ++i) {
        ask({i * side, 0}, {(i + 1) * side, side});
        ask({i * side, 0}, {i * side, side});
    }
    ask({1, 0}, {1, side});
    return largest;
}

}  // namespace mv
