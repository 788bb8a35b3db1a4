#include "mv/math/shadow.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// The plane with a unit normal.
vec4 unitPlane(std::string_view subject, const vec4& plane) {
    requireFinite(subject, "the plane", plane);
    const vec3 normal(plane);
    if (normal == vec3(0)) throw Error(subject, "the plane's normal must not be 0", vectorText(plane));
    const vec3 direction = unit(normal);
    // The length of a very small or large normal has all digits only when it is scaled.
    const int exponent = scalingExponent(largestComponent(normal));
    const double length = glm::dot(direction, timesPowerOfTwo(normal, -exponent));
    const vec4 result(direction, (exponent == 0 ? plane.w : std::scalbn(plane.w, -exponent)) / length);
    if (!isFinite(result)) {
        throw Error(subject, "the plane's normal and distance must not overflow", vectorText(plane));
    }
    return result;
}

void requireLight(std::string_view subject, const vec4& light) {
    requireFinite(subject, "the light", light);
    if (light.w < 0) {
        throw Error(subject, "the light's w must be 0 (direction) or positive (point)", vectorText(light));
    }
    if (light == vec4(0)) throw Error(subject, "the light must not be 0", vectorText(light));
}

// How a light stands over a plane, computed once.
struct LightHeight {
    double height;  // n.L
    double size;    // of its terms, whose rounding it may be
    double least;   // the part of size below which there is no telling
    bool clear() const { return std::abs(height) > least * size; }
};

LightHeight lightHeight(std::string_view subject, const vec4& light, const vec4& unitPlane) {
    const double height = glm::dot(unitPlane, light);
    const double size = std::hypot(light.x, light.y, light.z) + std::abs(unitPlane.w) * light.w;
    if (!std::isfinite(height) || !std::isfinite(size)) {
        throw Error(subject, "light and plane must not be so large that the matrix overflows", vectorText(light));
    }
    return {height, size, light.w == 0 ? 1e-12 : 1e-6};
}

// The plane turned so that n.L is positive.
struct LitPlane {
    vec4 plane;
    double height;
};

LitPlane litPlane(std::string_view subject, const vec4& light, const vec4& unitPlane) {
    const LightHeight over = lightHeight(subject, light, unitPlane);
    if (!over.clear()) {
        const std::string rule = "the light must be off the plane by more than " + numberText(over.least) +
                                 (light.w == 0 ? " rad" : " of its distance from the origin");
        throw Error(subject, rule, numberText(std::abs(over.height)) + " of " + numberText(over.size));
    }
    return over.height > 0 ? LitPlane{unitPlane, over.height} : LitPlane{-unitPlane, -over.height};
}

// n.L without the plane's distance: what is left of w' = n.L - L.w (n.p) where p = 0. As a difference it would cancel.
double heightAlongNormal(const vec4& plane, const vec4& light) { return glm::dot(vec3(plane), vec3(light)); }

mat4 projectionOnto(std::string_view subject, const vec4& light, const vec4& unitPlane) {
    const auto [n, height] = litPlane(subject, light, unitPlane);
    mat4 result(height);
    for (int column = 0; column < 4; ++column) result[column] -= n[column] * light;
    result[3][3] = heightAlongNormal(n, light);
    if (!isFinite(result)) {
        throw Error(subject, "light and plane must not be so large that the matrix overflows", vectorText(light));
    }
    return result;
}

}  // namespace

mat4 shadowProjection(const vec4& light, const vec4& plane) {
    requireLight("shadowProjection", light);
    return projectionOnto("shadowProjection", light, unitPlane("shadowProjection", plane));
}

mat4 shadowProjection(const vec4& light, const vec4& plane, const vec3& origin) {
    requireLight("shadowProjection", light);
    requireFinite("shadowProjection", "the origin", origin);
    const vec4 n = unitPlane("shadowProjection", plane);
    const double off = std::abs(glm::dot(vec3(n), origin) + n.w);
    if (!(off <= 1e-12 * (std::hypot(origin.x, origin.y, origin.z) + std::abs(n.w)))) {
        throw Error("shadowProjection", "the origin must lie on the plane", numberText(off) + " off");
    }
    // Rounded once: light and origin may be far away, and near each other.
    const auto local = [&](int i) { return std::fma(-origin[i], light.w, light[i]); };
    const vec4 localLight(local(0), local(1), local(2), light.w);
    requireFinite("shadowProjection", "the light relative to the origin", localLight);
    return projectionOnto("shadowProjection", localLight, vec4(vec3(n), 0));
}

std::array<vec4, 2> shadowCasterBounds(const vec4& light, const vec4& plane) {
    requireLight("shadowCasterBounds", light);
    const vec4 n = litPlane("shadowCasterBounds", light, unitPlane("shadowCasterBounds", plane)).plane;
    return {n, vec4(-light.w * vec3(n), heightAlongNormal(n, light))};
}

int lightSide(const vec4& light, const vec4& plane) {
    requireLight("lightSide", light);
    const LightHeight over = lightHeight("lightSide", light, unitPlane("lightSide", plane));
    return !over.clear() ? 0 : over.height > 0 ? 1 : -1;
}

mat4 reflection(const vec4& plane) {
    const vec4 n = unitPlane("reflection", plane);
    mat4 result(1);
    for (int column = 0; column < 4; ++column) result[column] -= vec4(2 * n[column] * vec3(n), 0);
    if (!isFinite(result))
        throw Error("reflection", "the plane's normal and distance must not overflow", vectorText(plane));
    return result;
}

}  // namespace mv
