#include "mv/math/transform.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mv/error.h"
#include "mv/math/exact_sum.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

struct Turn {
    double sine, cosine;
};

Turn turnOf(std::string_view subject, double degrees) {
    // fmod is exact and would leave angles within one turn as they are, bit for bit what MV.js computes.
    if (!(std::abs(degrees) < 360)) {
        requireFinite(subject, "the angle", degrees);
        degrees = std::fmod(degrees, 360.0);
    }
    const double angle = radians(degrees);
    return {std::sin(angle), std::cos(angle)};
}

// Coordinates up to this size leave room for the sums and differences below, so that no result overflows.
constexpr double largestCoordinate = 1e300;

void requireCoordinates(std::string_view subject, std::string_view name, const vec3& v) {
    requireFinite(subject, name, v);
    if (largestComponent(v) > largestCoordinate) {
        throw Error(subject, std::string(name).append(" must lie within 1e300 of the origin"), vectorText(v));
    }
}

vec3 viewOf(std::string_view subject, const vec3& eye, const vec3& at) {
    requireCoordinates(subject, "eye", eye);
    requireCoordinates(subject, "at", at);
    if (eye == at) throw Error(subject, "eye and at must differ", vectorText(eye));
    return at - eye;
}

mat4 cameraFromAxes(const vec3& eye, const vec3& right, const vec3& top, const vec3& forward) {
    const vec3 back = -forward;
    // clang-format off
    return {right.x,                top.x,                back.x,                0,
            right.y,                top.y,                back.y,                0,
            right.z,                top.z,                back.z,                0,
            -glm::dot(right, eye),  -glm::dot(top, eye),  -glm::dot(back, eye),  1};  // column by column
    // clang-format on
}

// The plain cross product loses a digit and more if up is less than 0.1 rad off the line of sight.
bool isAside(const vec3& sideways, double upSquares) { return glm::dot(sideways, sideways) >= 1e-2 * upSquares; }

// The part of the difference at - eye that rounding took. Source: Knuth's exact sum, TAOCP volume 2, 4.2.2.
vec3 roundingOfDifference(const vec3& at, const vec3& eye, const vec3& difference) {
    const vec3 minusEye = difference - at;
    return (at - (difference - minusEye)) - (eye + minusEye);
}

// The camera for any arguments: refuses, scales, and takes care of an up nearly parallel to the view.
[[gnu::cold, gnu::noinline]] mat4 carefulCamera(std::string_view subject, const vec3& eye, const vec3& at,
                                                const vec3& up) {
    const vec3 view = viewOf(subject, eye, at);
    const vec3 toAt = scaledForSquares(view);
    requireFinite(subject, "up", up);
    if (up == vec3(0)) throw Error(subject, "up must not be 0", vectorText(up));
    const vec3 upward = scaledForSquares(up);
    const vec3 forward = unit(toAt);
    vec3 sideways = glm::cross(forward, upward);
    if (!isAside(sideways, glm::dot(upward, upward))) {
        // At an angle of 1e-10 rad even the rounding of the view is a millionth of what is left of up: so it is kept.
        const int exponent = -scalingExponent(largestComponent(view));
        const vec3 rest = timesPowerOfTwo(roundingOfDifference(at, eye, view), exponent);
        sideways = accurateCross(toAt, upward) + glm::cross(rest, upward);
        const double angle = glm::length(sideways) / (glm::length(toAt) * glm::length(upward));
        if (angle < 1e-12) {
            throw Error(subject, "up must be at least 1e-12 rad off the line of sight", numberText(angle) + " rad");
        }
    }
    const vec3 right = unit(sideways);
    return cameraFromAxes(eye, right, unit(glm::cross(right, forward)), forward);
}

mat4 cameraFromWorld(std::string_view subject, const vec3& eye, const vec3& at, const vec3& up) {
    // The operations of MV.js in its order. The comparisons fail for NaN: what passes them leaves nothing to refuse.
    const vec3 view = at - eye;
    const double viewSquares = glm::dot(view, view);
    const double upSquares = glm::dot(up, up);
    if (isOrdinary(viewSquares) && isOrdinary(upSquares) && glm::dot(eye, eye) < largestCoordinate) {
        const vec3 forward = view / std::sqrt(viewSquares);
        const vec3 sideways = glm::cross(forward, up);
        if (isAside(sideways, upSquares)) {
            const vec3 right = sideways / std::sqrt(glm::dot(sideways, sideways));
            const vec3 upright = glm::cross(right, forward);
            return cameraFromAxes(eye, right, upright / std::sqrt(glm::dot(upright, upright)), forward);
        }
    }
    return carefulCamera(subject, eye, at, up);
}

// Whether three columns with these squared lengths span enough of their volume for plain products: the angle between
// any two is not small (the first term), nor is one far shorter than another (the second). The bound leaves 14 of 15
// digits to the products. Scaling all columns alike changes nothing.
bool spansEnough(double span, double xx, double yy, double zz) {
    const double sum = xx + yy + zz;
    return span * span > 1e-2 * xx * yy * zz + 1e-12 * sum * sum * sum;
}

// The factor that brings cofactors to a normal matrix: a rotation, times any one scale, gives the rotation, since the
// squares of its columns sum to three times the scale's square. Only the determinant's sign is read.
double cofactorScale(double squaresOfColumns, double determinant) {
    return (determinant < 0 ? -3 : 3) / squaresOfColumns;
}

// The sign of the determinant of these columns, whose cofactors are given: by its value where rounding cannot have turned
// that over, and else exactly.
int determinantSign(const mat3& m, const mat3& cofactors) {
    const vec3 terms = cofactors[0] * m[0];
    const double determinant = terms.x + terms.y + terms.z;
    const double sizes = std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z);
    if (std::abs(determinant) > 1e-15 * sizes) return determinant > 0 ? 1 : -1;
    ExactSum<24> sum;
    const auto addProduct = [&](double a, double b, double c) {
        const double product = a * b;
        sum.addProduct(product, c);
        sum.addProduct(std::fma(a, b, -product), c);
    };
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, l = (i + 2) % 3;
        addProduct(m[0][i], m[1][k], m[2][l]);
        addProduct(-m[0][i], m[1][l], m[2][k]);
    }
    return sum.sign();
}

// The normal matrix of any m: refuses, scales, and takes care of columns that span little.
[[gnu::cold, gnu::noinline]] mat3 carefulNormalMatrix(const mat4& m) {
    requireFinite("normalMatrix", "the matrix", m);

    // Scaled where needed, so that the products of scale(1e-200) do not vanish.
    mat3 linear(m);
    double largest = 0;
    for (int i = 0; i < 3; ++i) largest = std::max(largest, largestComponent(vec3(linear[i])));
    for (int i = 0; i < 3; ++i) linear[i] = timesPowerOfTwo(vec3(linear[i]), -scalingExponent(largest));
    const double xx = glm::dot(linear[0], linear[0]);
    const double yy = glm::dot(linear[1], linear[1]);
    const double zz = glm::dot(linear[2], linear[2]);
    mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                   glm::cross(linear[0], linear[1]));
    const double span = glm::dot(cofactors[0], linear[0]);
    if (spansEnough(span, xx, yy, zz)) return cofactors * cofactorScale(xx + yy + zz, span);

    // Each column by itself, so that the products of scale(1, 1e-200, 1e-200) do not vanish.
    linear = mat3(m);
    std::array<int, 3> exponent{};
    for (int i = 0; i < 3; ++i) {
        const double size = largestComponent(vec3(linear[i]));
        if (size == 0) continue;
        exponent[static_cast<std::size_t>(i)] = std::ilogb(size);
        linear[i] = timesPowerOfTwo(vec3(linear[i]), -exponent[static_cast<std::size_t>(i)]);
    }

    // Plain products would have cancelled where the columns span little; these do not. The cofactors' columns are as
    // much longer as those of the matrix were shorter, which is made up for relative to the longest.
    cofactors = mat3(accurateCross(linear[1], linear[2]), accurateCross(linear[2], linear[0]),
                     accurateCross(linear[0], linear[1]));
    const int sign = determinantSign(linear, cofactors);
    int longest = std::numeric_limits<int>::min();
    for (int i = 0; i < 3; ++i) {
        const double size = largestComponent(vec3(cofactors[i]));
        if (size > 0) longest = std::max(longest, std::ilogb(size) - exponent[static_cast<std::size_t>(i)]);
    }
    double squares = 0;
    for (int i = 0; i < 3; ++i) {
        // One that is 0 would overflow the exponents.
        if (vec3(cofactors[i]) == vec3(0)) continue;
        cofactors[i] = timesPowerOfTwo(vec3(cofactors[i]), -exponent[static_cast<std::size_t>(i)] - longest);
        squares += glm::dot(cofactors[i], cofactors[i]);
    }
    if (squares == 0) return mat3(0);
    return cofactors * ((sign < 0 ? -1 : 1) * std::sqrt(3 / squares));
}

// A matrix written two numbers at a time. The stores are the time where nothing is computed, and g++ 12 writes what
// GLM's constructor is given one by one: twice as many stores as GLM's own translate and scale, which multiply columns.
struct Column {
    double x, y, z, w;
};
mat4 fromColumns(const Column& a, const Column& b, const Column& c, const Column& d) {
    using Pair [[gnu::vector_size(16)]] = double;
    const std::array<Pair, 8> pairs{Pair{a.x, a.y}, Pair{a.z, a.w}, Pair{b.x, b.y}, Pair{b.z, b.w},
                                    Pair{c.x, c.y}, Pair{c.z, c.w}, Pair{d.x, d.y}, Pair{d.z, d.w}};
    return std::bit_cast<mat4>(pairs);
}

}  // namespace

// The matrices below are written column by column, so each stands transposed to its picture on paper.
// clang-format off
mat4 translate(const vec3& offset) {
    requireFinite("translate", "the offset", offset);
    return fromColumns({1,        0,        0,        0},
                       {0,        1,        0,        0},
                       {0,        0,        1,        0},
                       {offset.x, offset.y, offset.z, 1});
}

mat4 scale(const vec3& factors) {
    requireFinite("scale", "the factors", factors);
    return fromColumns({factors.x, 0,         0,         0},
                       {0,         factors.y, 0,         0},
                       {0,         0,         factors.z, 0},
                       {0,         0,         0,         1});
}
// clang-format on

mat4 translate(double x, double y, double z) { return translate(vec3(x, y, z)); }

mat4 scale(double x, double y, double z) { return scale(vec3(x, y, z)); }

mat4 scale(double factor) { return scale(vec3(factor)); }

// clang-format off
mat4 rotateX(double degrees) {
    const auto [s, c] = turnOf("rotateX", degrees);
    return {1,  0, 0, 0,
            0,  c, s, 0,
            0, -s, c, 0,
            0,  0, 0, 1};
}

mat4 rotateY(double degrees) {
    const auto [s, c] = turnOf("rotateY", degrees);
    return {c, 0, -s, 0,
            0, 1,  0, 0,
            s, 0,  c, 0,
            0, 0,  0, 1};
}

mat4 rotateZ(double degrees) {
    const auto [s, c] = turnOf("rotateZ", degrees);
    return { c, s, 0, 0,
            -s, c, 0, 0,
             0, 0, 1, 0,
             0, 0, 0, 1};
}

mat4 rotate(double degrees, const vec3& axis) {
    const auto [s, c] = turnOf("rotate", degrees);
    requireFinite("rotate", "the axis", axis);
    if (axis == vec3(0)) throw Error("rotate", "the axis must not be 0", vectorText(axis));
    const vec3 v = unit(axis);
    const double omc = 1.0 - c;
    return {v.x * v.x * omc + c,        v.x * v.y * omc + v.z * s,  v.x * v.z * omc - v.y * s,  0,
            v.x * v.y * omc - v.z * s,  v.y * v.y * omc + c,        v.y * v.z * omc + v.x * s,  0,
            v.x * v.z * omc + v.y * s,  v.y * v.z * omc - v.x * s,  v.z * v.z * omc + c,        0,
            0,                          0,                          0,                          1};
}
// clang-format on

mat4 lookAt(const vec3& eye, const vec3& at, const vec3& up) { return cameraFromWorld("lookAt", eye, at, up); }

mat4 lookAtAnyRoll(const vec3& eye, const vec3& at) {
    const vec3 view = at - eye;
    int least = 1;
    for (const int axis : {2, 0}) {
        if (std::abs(view[axis]) < std::abs(view[least])) least = axis;
    }
    vec3 up(0);
    up[least] = 1;
    return cameraFromWorld("lookAtAnyRoll", eye, at, up);
}

mat3 normalMatrix(const mat4& m) {
    const vec3 x(m[0]);
    const vec3 y(m[1]);
    const vec3 z(m[2]);
    const double xx = glm::dot(x, x);
    const double yy = glm::dot(y, y);
    const double zz = glm::dot(z, z);

    // The columns of the cofactor matrix are cross products of the columns.
    const vec3 yz = glm::cross(y, z);
    const vec3 zx = glm::cross(z, x);
    const vec3 xy = glm::cross(x, y);
    const double span = glm::dot(yz, x);

    // Ordinary sizes keep all squares and products from overflowing; where they vanish, spansEnough says no. Elements
    // that are not read have only to be finite, which their sum tells (one that overflows goes the careful way too).
    const double unread = m[0].w + m[1].w + m[2].w + m[3].x + m[3].y + m[3].z + m[3].w;
    const double squares = xx + yy + zz;
    if (!(squares <= 1e30) || !spansEnough(span, xx, yy, zz) || !isFinite(unread)) return carefulNormalMatrix(m);
    const double factor = cofactorScale(squares, span);
    return {yz * factor, zx * factor, xy * factor};
}

}  // namespace mv
