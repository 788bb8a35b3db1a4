#include "mv/motion/turn.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// operator* makes it of unit length, and refuses what is none.
quat unitOf(const quat& q) { return quat() * q; }

vec3 axisPart(const quat& q) { return {q.x, q.y, q.z}; }
quat quatOf(double w, const vec3& v) { return {w, v.x, v.y, v.z}; }

void requireDirection(const vec3& v) {
    requireFinite("turnBetween", "a direction", v);
    if (v == vec3(0)) throw Error("turnBetween", "a direction must not be 0", vectorText(v));
}

// The turn in the names of the axes by which xyz and zyx are yxz, and back. (x, y, z) -> (y, x, z) is a mirror.
quat renamed(const quat& q, EulerOrder order) {
    if (order == EulerOrder::xyz) return {q.w, -q.y, -q.x, -q.z};
    if (order == EulerOrder::zyx) return {q.w, q.y, q.z, q.x};
    return q;
}
quat renamedBack(const quat& q, EulerOrder order) {
    if (order == EulerOrder::zyx) return {q.w, q.z, q.x, q.y};
    return renamed(q, order);
}

}  // namespace

quat inverse(const quat& q) {
    const quat unit = unitOf(q);
    return quatOf(unit.w, -axisPart(unit));
}

AxisAngle axisAngleOf(const quat& q) {
    const quat turn = unitOf(q);
    const vec3 v = axisPart(turn);
    if (v == vec3(0)) return {};
    const vec3 axis = unit(v);
    return {2 * degrees(std::atan2(glm::dot(v, axis), std::abs(turn.w))), turn.w < 0 ? -axis : axis};
}

vec3 turned(const quat& q, const vec3& v) {
    requireFinite("turned", "the vector", v);
    const quat turn = unitOf(q);
    const vec3 u = axisPart(turn), twice = 2.0 * glm::cross(u, v);
    return v + turn.w * twice + glm::cross(u, twice);
}

quat turnBetween(const vec3& from, const vec3& to) {
    requireDirection(from);
    requireDirection(to);
    const vec3 a = unit(from), b = unit(to);
    const vec3 cross = accurateCross(a, b);  // of the length of the sine
    const bool isSharp = glm::dot(a, b) > 0;
    if (cross == vec3(0)) {
        if (isSharp) return {};
        const vec3 size = glm::abs(a);
        const int least = size.z <= size.x && size.z <= size.y ? 2 : size.y <= size.x ? 1 : 0;
        vec3 aside(0);
        aside[least] = 1;
        return quatOf(0, unit(accurateCross(a, aside)));
    }
    // The sum's length is twice the cosine of half the angle, the difference's twice its sine. The smaller of the two, which has
    // lost digits, follows from the sine of the angle, which has not.
    if (isSharp) {
        const double cosine = glm::length(a + b) / 2;
        return quatOf(cosine, cross / (2 * cosine));
    }
    const double sine = glm::length(b - a) / 2;
    const vec3 axis = unit(cross);
    return quatOf(glm::dot(cross, axis) / (2 * sine), sine * axis);
}

quat quatFromEuler(const vec3& degrees, EulerOrder order) {
    if (order == EulerOrder::xyz) return renamedBack(quatFromYawPitchRoll(-degrees.x, -degrees.y, -degrees.z), order);
    if (order == EulerOrder::zyx) return renamedBack(quatFromYawPitchRoll(degrees.z, degrees.y, degrees.x), order);
    return quatFromYawPitchRoll(degrees.y, degrees.x, degrees.z);
}

EulerAngles eulerAnglesOf(const quat& q, EulerOrder order) {
    const YawPitchRoll angles = yawPitchRollOf(renamed(q, order));
    const auto back = [](double degrees) { return degrees == 180 ? degrees : 0 - degrees; };  // (-180, 180]
    if (order == EulerOrder::xyz) return {{back(angles.yaw), 0 - angles.pitch, back(angles.roll)}, angles.locked};
    if (order == EulerOrder::zyx) return {{angles.roll, angles.pitch, angles.yaw}, angles.locked};
    return {{angles.pitch, angles.yaw, angles.roll}, angles.locked};
}

}  // namespace mv
