#include "support/shadow_rays.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "support/demo_run.h"

namespace mv::test {
namespace {

// The place where the way from a to b passes through the square, as a part of the way; nothing where it does not.
std::optional<double> throughSquare(const mat4& squareFromWorld, const vec3& a, const vec3& b) {
    const vec3 from(squareFromWorld * vec4(a, 1)), to(squareFromWorld * vec4(b, 1));
    if (from.y == to.y) return {};
    const double part = from.y / (from.y - to.y);
    const vec3 point = from + part * (to - from);
    if (part <= 0 || part >= 1 || std::abs(point.x) > 0.5 || std::abs(point.z) > 0.5) return {};
    return part;
}

vec3 unprojected(const mat4& worldFromClip, const vec2& ndc, double depth) {
    const vec4 point = worldFromClip * vec4(ndc, depth, 1);
    return vec3(point) / point.w;
}

Seen castRay(const ShadowScene& scene, const mat4& worldFromClip, const mat4& squareFromWorld, const vec2& ndc) {
    const vec3 near = unprojected(worldFromClip, ndc, -1), far = unprojected(worldFromClip, ndc, 1);
    const auto square = throughSquare(squareFromWorld, near, far);
    const double part = near.y / (near.y - far.y);
    if (!(part > 0 && part < 1) || (square && *square < part)) return square ? Seen::square : Seen::background;
    const vec3 point = near + part * (far - near);
    const bool onFloor = std::abs(point.x) <= scene.floorHalf && std::abs(point.z) <= scene.floorHalf;
    const bool dark = scene.light.y > 0 && throughSquare(squareFromWorld, point, scene.light).has_value();
    if (onFloor) return dark && near.y > 0 ? Seen::shadow : Seen::floor;
    if (dark && scene.beyondFloor) return Seen::shadow;
    return square ? Seen::square : Seen::background;
}

}  // namespace

Seen castRay(const ShadowScene& scene, const vec2& ndc) {
    return castRay(scene, glm::inverse(scene.clipFromWorld), glm::inverse(scene.worldFromSquare), ndc);
}

RayComparison compareWithRays(const Picture& picture, const ShadowScene& scene, const SeenColors& colors,
                              std::optional<vec2> except) {
    const mat4 worldFromClip = glm::inverse(scene.clipFromWorld), squareFromWorld = glm::inverse(scene.worldFromSquare);
    const auto seenAt = [&](double x, double y) {
        return castRay(scene, worldFromClip, squareFromWorld, {2 * x / picture.width - 1, 1 - 2 * y / picture.height});
    };
    RayComparison result;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const double x = column + 0.5, y = row + 0.5;
            if (except && glm::length(vec2(x, y) - *except) < 20) continue;
            const Seen seen = seenAt(x, y);
            bool edge = false;
            for (const vec2& aside : {vec2(1, 0), vec2(-1, 0), vec2(0, 1), vec2(0, -1)}) {
                edge = edge || seenAt(x + aside.x, y + aside.y) != seen;
            }
            if (edge) continue;
            ++result.compared;
            result.shadow += seen == Seen::shadow;
            result.wrong += sameColor(picture.at(column, row), colors[static_cast<std::size_t>(seen)]) ? 0 : 1;
        }
    }
    return result;
}

}  // namespace mv::test
