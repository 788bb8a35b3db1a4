#include "mv/motion/orientation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// Dot products of unit quaternions are known to some roundings: below this one is 0.
constexpr double dotRounding = 1e-15;

// Quaternions as vectors (w, x, y, z).
vec4 vectorOf(const quat& q) { return {q.w, q.x, q.y, q.z}; }
quat quatOf(const vec4& v) { return {v[0], v[1], v[2], v[3]}; }

// The quaternion times a power of two: itself in the ordinary range, else of a size of 1.
vec4 scaled(std::string_view subject, const quat& q) {
    const vec4 v = vectorOf(q);
    if (isOrdinary(glm::dot(v, v))) return v;
    requireFinite(subject, "the quaternion", v);
    if (v == vec4(0)) throw Error(subject, "the quaternion must not be 0", vectorText(v));
    return timesPowerOfTwo(v, -std::ilogb(largestComponent(v)));
}

vec4 unitOf(const vec4& v) { return v / std::sqrt(glm::dot(v, v)); }
vec4 unitOf(std::string_view subject, const quat& q) { return unitOf(scaled(subject, q)); }

// The same orientation with the first component positive that is not 0 to this tolerance.
vec4 withSign(const vec4& v, double tolerance) {
    for (int i = 0; i < 4; ++i) {
        if (std::abs(v[i]) > tolerance) return v[i] < 0 ? -v : v;
    }
    return v;
}

struct Turn {
    double sine, cosine;
};

// The sine of half the angle. Quarters are taken off in whole numbers, so that what is left is small and multiples of
// 90 are exact.
Turn halfTurn(std::string_view subject, double degrees) {
    requireFinite(subject, "the angle", degrees);
    int quarters = 0;
    const double rest = radians(std::remquo(degrees / 2, 90.0, &quarters));
    const double s = std::sin(rest), c = std::cos(rest);
    switch (quarters & 3) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

double inHalfTurn(double degrees) {
    const double angle = std::remainder(degrees, 360.0);
    return angle <= -180 ? 180 : angle;
}

void requireMoment(std::string_view subject, double t) {
    if (!(std::abs(t) <= 1e6)) throw Error(subject, "t must be -1e6 to 1e6", numberText(t));
}

// Both ends as unit vectors, of which `to` has the sign that makes the arc between them the shorter way.
struct ArcEnds {
    vec4 from, to;
};
ArcEnds endsOf(std::string_view subject, const quat& from, const quat& to) {
    const vec4 a = unitOf(subject, from), b = unitOf(subject, to);
    const double dot = glm::dot(a, b);
    if (std::abs(dot) > dotRounding) return {a, dot < 0 ? -b : b};
    // Turning over both ends is the same arc: so `from` keeps its sign.
    const bool isTurned = withSign(a, dotRounding) != a;
    return {a, isTurned ? -withSign(b, dotRounding) : withSign(b, dotRounding)};
}

void requireRotation(const mat3& m) {
    const mat3 squares = glm::transpose(m) * m;
    double off = 0;
    for (int i = 0; i < 3; ++i) {
        vec3 column = squares[i];
        column[i] -= 1;
        off = std::max(off, largestComponent(column));
    }
    if (!(off <= 1e-6)) {
        throw Error("quatFromMatrix", "R^T R must be the identity to 1e-6 (take scales off by decompose)",
                    numberText(off) + " off");
    }
    if (glm::dot(glm::cross(m[0], m[1]), m[2]) < 0) {
        throw Error("quatFromMatrix", "the matrix must not mirror (take scales off by decompose)", "determinant -1");
    }
}

}  // namespace

quat quatFromAxis(double degrees, const vec3& axis) {
    const Turn half = halfTurn("quatFromAxis", degrees);
    requireFinite("quatFromAxis", "the axis", axis);
    if (axis == vec3(0)) throw Error("quatFromAxis", "the axis must not be 0", vectorText(axis));
    const vec3 v = half.sine * unit(axis);
    return {half.cosine, v.x, v.y, v.z};
}

mat4 rotationMatrix(const quat& q) {
    const vec4 v = scaled("rotationMatrix", q);
    const double w = v[0], x = v[1], y = v[2], z = v[3];
    const double s = 2 / glm::dot(v, v);
    // clang-format off
    return {1 - s * (y * y + z * z),  s * (x * y + w * z),      s * (x * z - w * y),      0,
            s * (x * y - w * z),      1 - s * (x * x + z * z),  s * (y * z + w * x),      0,
            s * (x * z + w * y),      s * (y * z - w * x),      1 - s * (x * x + y * y),  0,
            0,                        0,                        0,                        1};  // column by column
    // clang-format on
}

quat quatFromMatrix(const mat4& rotation) {
    requireFinite("quatFromMatrix", "the matrix", rotation);
    const mat3 m(rotation);
    requireRotation(m);

    // 4 w q, or x, y, z in the place of w: that of which the square is largest, at least 1/4.
    const vec3 twist(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]);
    const double trace = m[0][0] + m[1][1] + m[2][2];
    int i = 0;
    for (const int k : {1, 2}) {
        if (m[k][k] > m[i][i]) i = k;
    }
    if (trace >= m[i][i]) return quatOf(withSign(unitOf(vec4(1 + trace, twist)), 0));
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    vec4 v;
    v[0] = twist[i];
    v[1 + i] = 1 + m[i][i] - m[k][k] - m[l][l];
    v[1 + k] = m[i][k] + m[k][i];
    v[1 + l] = m[i][l] + m[l][i];
    return quatOf(withSign(unitOf(v), 0));
}

quat operator*(const quat& a, const quat& b) {
    const quat p = quatOf(scaled("quaternion product", a)), q = quatOf(scaled("quaternion product", b));
    return quatOf(
        unitOf("quaternion product",
               {(p.w * q.w - p.x * q.x) - (p.y * q.y + p.z * q.z), (p.w * q.x + p.x * q.w) + (p.y * q.z - p.z * q.y),
                (p.w * q.y + p.y * q.w) + (p.z * q.x - p.x * q.z), (p.w * q.z + p.z * q.w) + (p.x * q.y - p.y * q.x)}));
}

double angleBetween(const quat& a, const quat& b) {
    const vec4 u = unitOf("angleBetween", a), v = unitOf("angleBetween", b);
    const double apart = glm::length(u - v), together = glm::length(u + v);
    return degrees(4 * std::atan2(std::min(apart, together), std::max(apart, together)));
}

quat slerp(const quat& from, const quat& to, double t, Way way) {
    requireMoment("slerp", t);
    ArcEnds ends = endsOf("slerp", from, to);
    if (way == Way::longer) ends.to = -ends.to;
    const vec4 sum = ends.from + ends.to, difference = ends.to - ends.from;
    const double along = glm::length(sum), across = glm::length(difference);
    if (along < 2e-12) {
        throw Error("slerp", "the longer way must have an axis: ends must be 4e-12 rad apart",
                    numberText(2 * along) + " rad");
    }
    if (t == 0 || across == 0) return quatOf(ends.from);
    if (t == 1) return quatOf(ends.to);
    const double angle = (2 * t - 1) * std::atan2(across, along);  // from the middle
    return quatOf(std::cos(angle) / along * sum + std::sin(angle) / across * difference);
}

quat nlerp(const quat& from, const quat& to, double t) {
    requireMoment("nlerp", t);
    const ArcEnds ends = endsOf("nlerp", from, to);
    if (t == 0) return quatOf(ends.from);
    if (t == 1) return quatOf(ends.to);
    return quatOf(unitOf((ends.from + ends.to) + (2 * t - 1) * (ends.to - ends.from)));
}

quat quatFromYawPitchRoll(double yaw, double pitch, double roll) {
    const Turn y = halfTurn("quatFromYawPitchRoll", yaw), p = halfTurn("quatFromYawPitchRoll", pitch),
               r = halfTurn("quatFromYawPitchRoll", roll);
    return {y.cosine * p.cosine * r.cosine + y.sine * p.sine * r.sine,
            y.cosine * p.sine * r.cosine + y.sine * p.cosine * r.sine,
            y.sine * p.cosine * r.cosine - y.cosine * p.sine * r.sine,
            y.cosine * p.cosine * r.sine - y.sine * p.sine * r.cosine};
}

YawPitchRoll yawPitchRollOf(const quat& q) {
    const vec4 u = unitOf("yawPitchRollOf", q);
    const double w = u[0], x = u[1], y = u[2], z = u[3];
    // With h = pitch/2: (w - x, y + z) is cos h - sin h in the direction of (yaw + roll)/2, (w + x, y - z) is
    // cos h + sin h in that of (yaw - roll)/2.
    const double low = std::hypot(w - x, y + z), high = std::hypot(w + x, y - z);
    const double halfSum = degrees(std::atan2(y + z, w - x)), halfDifference = degrees(std::atan2(y - z, w + x));
    constexpr double lockedBelow = 1e-14;
    if (low < lockedBelow) return {inHalfTurn(2 * halfDifference), 90, 0, true};
    if (high < lockedBelow) return {inHalfTurn(2 * halfSum), -90, 0, true};
    return {inHalfTurn(halfSum + halfDifference), degrees(2 * std::atan2(high, low)) - 90,
            inHalfTurn(halfSum - halfDifference), false};
}

}  // namespace mv
