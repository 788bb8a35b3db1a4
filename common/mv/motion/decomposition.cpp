#include "mv/motion/decomposition.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

double lengthOf(const vec3& v) {
    const int exponent = scalingExponent(largestComponent(v));
    const double length = std::scalbn(glm::length(timesPowerOfTwo(v, -exponent)), exponent);
    if (!isFinite(length)) throw Error("decompose", "scales must not overflow", vectorText(v));
    return length;
}

// The unit axis least aligned with v: any that is not along it would do.
vec3 axisAside(const vec3& v) {
    int least = 0;
    for (const int i : {1, 2}) {
        if (std::abs(v[i]) < std::abs(v[least])) least = i;
    }
    vec3 axis(0);
    axis[least] = 1;
    return axis;
}

// Unit axes instead of those that are 0, perpendicular to the others, right-handed.
void completeAxes(mat3& axes, const std::array<bool, 3>& isThere) {
    const int count = isThere[0] + isThere[1] + isThere[2];
    if (count == 0) axes = mat3(1);
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, l = (i + 2) % 3;
        const auto there = [&](int axis) { return isThere[static_cast<std::size_t>(axis)]; };
        if (count == 1 && there(i)) {
            axes[k] = unit(glm::cross(axes[i], axisAside(axes[i])));
            axes[l] = glm::cross(axes[i], axes[k]);
        }
        if (count == 2 && !there(i)) axes[i] = unit(glm::cross(axes[k], axes[l]));
    }
}

void requirePerpendicular(const mat3& axes, int i, int k) {
    if (std::abs(glm::dot(axes[i], axes[k])) <= 1e-6) return;
    const double apart = glm::length(axes[i] - axes[k]), together = glm::length(axes[i] + axes[k]);
    constexpr std::array names{"x", "y", "z"};
    const std::string pair =
        std::string(names[static_cast<std::size_t>(i)]) + " and " + names[static_cast<std::size_t>(k)];
    throw Error("decompose", "the matrix must not shear: axes " + pair + " must be perpendicular",
                numberText(degrees(2 * std::atan2(apart, together))) + " degrees apart");
}

}  // namespace

Decomposition decompose(const mat4& m) {
    requireFinite("decompose", "the matrix", m);
    const vec4 lastRow(m[0][3], m[1][3], m[2][3], m[3][3]);
    if (lastRow != vec4(0, 0, 0, 1)) throw Error("decompose", "the last row must be 0 0 0 1", vectorText(lastRow));

    Decomposition parts{.translation = vec3(m[3]), .rotation = {}, .scale = vec3(0)};
    mat3 axes(0);
    std::array<bool, 3> isThere{};
    for (int i = 0; i < 3; ++i) {
        const vec3 column(m[i]);
        if (column == vec3(0)) continue;
        isThere[static_cast<std::size_t>(i)] = true;
        parts.scale[i] = lengthOf(column);
        axes[i] = unit(column);
    }
    for (const int i : {0, 1, 2}) requirePerpendicular(axes, i, (i + 1) % 3);
    completeAxes(axes, isThere);
    if (glm::dot(glm::cross(axes[0], axes[1]), axes[2]) < 0) {
        axes[0] = -axes[0];
        parts.scale.x = -parts.scale.x;
    }
    parts.rotation = quatFromMatrix(mat4(axes));
    return parts;
}

}  // namespace mv
