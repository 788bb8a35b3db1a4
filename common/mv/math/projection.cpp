#include "mv/math/projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"
#include "mv/math/unproject.h"

namespace mv {
namespace {

void requireDifferent(std::string_view subject, std::string_view firstName, double first, std::string_view secondName,
                      double second) {
    requireFinite(subject, firstName, first);
    requireFinite(subject, secondName, second);
    if (first != second) return;
    throw Error(subject, std::string(firstName).append(" and ").append(secondName).append(" must differ"),
                numberText(first));
}

void requireDepthRange(std::string_view subject, double near, double far) {
    requirePositive(subject, "near", near);
    requireFinite(subject, "far", far);
    if (far > near) return;
    throw Error(subject, "far must be greater than near", "near " + numberText(near) + ", far " + numberText(far));
}

// The functions below first make sure, by a few comparisons, that nothing is wrong; where something is, one of these
// finds out what. Out of line, so that the sentences cost an accepted call nothing.
[[noreturn, gnu::cold, gnu::noinline]] void refuseOverflow(std::string_view subject) {
    throw Error(subject, "the bounds must be neither so close nor so far apart that the matrix overflows");
}

[[noreturn, gnu::cold, gnu::noinline]] void refuseOrtho(const FrustumBounds& b) {
    requireDifferent("ortho", "left", b.left, "right", b.right);
    requireDifferent("ortho", "bottom", b.bottom, "top", b.top);
    requireDifferent("ortho", "near", b.near, "far", b.far);
    refuseOverflow("ortho");
}

[[noreturn, gnu::cold, gnu::noinline]] void refuseFrustum(const FrustumBounds& b) {
    requireDifferent("frustum", "left", b.left, "right", b.right);
    requireDifferent("frustum", "bottom", b.bottom, "top", b.top);
    requireDepthRange("frustum", b.near, b.far);
    refuseOverflow("frustum");
}

void requireAngles(std::string_view subject, double fovy, double aspect) {
    if (!(fovy > 0 && fovy < 180)) {
        throw Error(subject, "fovy must be greater than 0 and less than 180 degrees", numberText(fovy));
    }
    requirePositive(subject, "aspect", aspect);
}

[[gnu::cold, gnu::noinline]] void refuseView(std::string_view subject, double fovy, double aspect, double near,
                                             double far) {
    requireAngles(subject, fovy, aspect);
    requireDepthRange(subject, near, far);
}

[[noreturn, gnu::cold, gnu::noinline]] void refuseInfiniteView(double fovy, double aspect, double near) {
    requireAngles("infinitePerspective", fovy, aspect);
    requirePositive("infinitePerspective", "near", near);
    refuseOverflow("infinitePerspective");
}

// Half the angle of view. The height of the window at distance 1 is twice the tangent.
struct HalfAngle {
    double tangent, cotangent;
};
HalfAngle halfAngle(double fovy) {
    // Above 90 degrees by what is missing to 180, which is exact: the tangent of nearly 90 degrees would magnify the
    // rounding of the radians without bound.
    const bool isWide = fovy > 90;
    const double t = std::tan(radians(isWide ? 180 - fovy : fovy) / 2);
    return isWide ? HalfAngle{1 / t, t} : HalfAngle{t, 1 / t};
}
HalfAngle checkedHalfAngle(std::string_view subject, double fovy, double aspect, double near, double far) {
    const bool isView = fovy > 0 && fovy < 180 && aspect > 0 && aspect < HUGE_VAL && near > 0 && near < far &&
                        far < HUGE_VAL;  // false for NaN
    if (!isView) refuseView(subject, fovy, aspect, near, far);
    return halfAngle(fovy);
}

// 2 near far/(far - near), also where the product would vanish or overflow and the quotient does not.
double twiceNearFarOver(double d, double near, double far) {
    const double product = 2 * near * far;
    return isOrdinary(product) ? product / d : 2 * near * (far / d);
}

// Solves m x = b by Gaussian elimination with pivots, and mends each answer by what is left of b - m x, which is computed
// with twice the digits: so the error is that of some roundings of the matrix's entries, each of its own size, however
// different their sizes are. Source: Skeel, "Iterative refinement implies numerical stability for Gaussian elimination",
// Math. Comp. 35 (1980). A matrix without an inverse gives NaN or infinity.
class Elimination {
  public:
    explicit Elimination(const mat4& m) : m_(m), rows_(glm::transpose(m)) {
        // A pivot is judged by what its row is made of: a small number beside a row's 1e9 would leave nothing of the others.
        vec4 sizes;
        for (int row = 0; row < 4; ++row) sizes[row] = largestComponent(rows_[row]);
        for (int k = 0; k < 4; ++k) {
            int pivot = k;
            for (int row = k + 1; row < 4; ++row) {
                if (std::abs(rows_[row][k]) * sizes[pivot] > std::abs(rows_[pivot][k]) * sizes[row]) pivot = row;
            }
            std::swap(rows_[k], rows_[pivot]);
            std::swap(sizes[k], sizes[pivot]);
            std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(pivot)]);
            for (int row = k + 1; row < 4; ++row) {
                const double factor = rows_[row][k] / rows_[k][k];
                for (int column = k + 1; column < 4; ++column) rows_[row][column] -= factor * rows_[k][column];
                rows_[row][k] = factor;
            }
        }
    }

    // Nothing where no x solves a matrix whose entries differ from m's by but a few roundings.
    std::optional<vec4> solve(const vec4& b) const {
        vec4 x = once(b);
        for (int step = 0; step < 3; ++step) x += once(rest(b, x));
        const vec4 left = rest(b, x);
        for (int row = 0; row < 4; ++row) {
            double terms = 0;
            for (int column = 0; column < 4; ++column) terms += std::abs(m_[column][row] * x[column]);
            if (!(std::abs(left[row]) <= mostLeft * terms)) return {};
        }
        return x;
    }

  private:
    // The remainder of a row, as a part of its terms: x is rounded, which is a quarter of this.
    static constexpr double mostLeft = 2 * std::numeric_limits<double>::epsilon();

    vec4 once(const vec4& b) const {
        vec4 x;
        for (int row = 0; row < 4; ++row) {
            x[row] = b[order_[static_cast<std::size_t>(row)]];
            for (int column = 0; column < row; ++column) x[row] -= rows_[row][column] * x[column];
        }
        for (int row = 3; row >= 0; --row) {
            for (int column = row + 1; column < 4; ++column) x[row] -= rows_[row][column] * x[column];
            x[row] /= rows_[row][row];
        }
        return x;
    }

    // b - m x: the roundings of the products and of their sums are kept beside them.
    vec4 rest(const vec4& b, const vec4& x) const {
        vec4 result;
        for (int row = 0; row < 4; ++row) {
            double sum = b[row], lost = 0;
            for (int column = 0; column < 4; ++column) {
                const double product = -m_[column][row] * x[column];
                lost += std::fma(-m_[column][row], x[column], -product);
                const double next = sum + product, added = next - sum;  // Knuth's sum, TAOCP volume 2, 4.2.2
                lost += (sum - (next - added)) + (product - added);
                sum = next;
            }
            result[row] = sum + lost;
        }
        return result;
    }

    mat4 m_;
    mat4 rows_;  // row by row: the factors below the diagonal, on it and above it the upper triangle
    std::array<int, 4> order_{0, 1, 2, 3};
};

// The product of three positive numbers, of which two may overflow or vanish.
double product(const std::array<double, 3>& factors) {
    double mantissa = 1;
    int exponent = 0;
    for (const double factor : factors) {
        int ofFactor = 0;
        mantissa *= std::frexp(factor, &ofFactor);
        exponent += ofFactor;
    }
    return std::ldexp(mantissa, exponent);
}

}  // namespace

// The matrices below are written column by column, so each stands transposed to its picture on paper.
mat4 ortho(double left, double right, double bottom, double top, double near, double far) {
    const double w = right - left;
    const double h = top - bottom;
    const double d = far - near;
    const vec3 factor(2.0 / w, 2.0 / h, -2.0 / d);
    const vec3 offset(-(left + right) / w, -(top + bottom) / h, -(near + far) / d);
    // Two equal bounds give infinity (or 0/0), and one that is not finite gives NaN as an offset. Bounds so far apart that
    // their difference overflows would give 0, a flattened picture.
    if (!isFinite(factor) || !isFinite(offset) || !isFinite(vec3(w, h, d)))
        refuseOrtho({left, right, bottom, top, near, far});
    // clang-format off
    return {factor.x, 0,        0,        0,
            0,        factor.y, 0,        0,
            0,        0,        factor.z, 0,
            offset.x, offset.y, offset.z, 1};
    // clang-format on
}

mat4 perspective(double fovy, double aspect, double near, double far) {
    const double f = checkedHalfAngle("perspective", fovy, aspect, near, far).cotangent;
    const double d = far - near;
    const vec4 element(f / aspect, f, -(near + far) / d, -twiceNearFarOver(d, near, far));
    if (!isFinite(element)) refuseOverflow("perspective");
    // clang-format off
    return {element.x, 0,         0,          0,
            0,         element.y, 0,          0,
            0,         0,         element.z, -1,
            0,         0,         element.w,  0};
    // clang-format on
}

mat4 infinitePerspective(double fovy, double aspect, double near) {
    const double f = halfAngle(fovy).cotangent;
    const vec3 element(f / aspect, f, -2 * near);
    const bool isView = fovy > 0 && fovy < 180 && aspect > 0 && aspect < HUGE_VAL && near > 0;  // false for NaN
    if (!isView || !isFinite(element)) refuseInfiniteView(fovy, aspect, near);
    // clang-format off
    return {element.x, 0,         0,          0,
            0,         element.y, 0,          0,
            0,         0,         -1,        -1,
            0,         0,         element.z,  0};
    // clang-format on
}

mat4 frustum(double left, double right, double bottom, double top, double near, double far) {
    const double w = right - left;
    const double h = top - bottom;
    const double d = far - near;
    const vec2 factor(2 * near / w, 2 * near / h);
    const vec4 third((right + left) / w, (top + bottom) / h, -(far + near) / d, -twiceNearFarOver(d, near, far));
    // As in ortho: equal or infinite bounds show in the third column.
    if (!(near > 0 && far > near && isFinite(factor) && isFinite(third) && isFinite(vec3(w, h, d)))) {
        refuseFrustum({left, right, bottom, top, near, far});
    }
    // clang-format off
    return {factor.x, 0,        0,        0,
            0,        factor.y, 0,        0,
            third.x,  third.y,  third.z, -1,
            0,        0,        third.w,  0};
    // clang-format on
}

FrustumBounds frustumBounds(double fovy, double aspect, double near, double far) {
    const double tangent = checkedHalfAngle("frustumBounds", fovy, aspect, near, far).tangent;
    const double top = near * tangent;
    // The width need not vanish or lose digits where the height does: so it is no product of it.
    const double right = isOrdinary(top) ? top * aspect : product({near, tangent, aspect});
    if (!(top < HUGE_VAL && right < HUGE_VAL)) refuseOverflow("frustumBounds");
    return {-right, right, -top, top, near, far};
}

mat4 frustum(const FrustumBounds& bounds) {
    return frustum(bounds.left, bounds.right, bounds.bottom, bounds.top, bounds.near, bounds.far);
}

namespace {

// Its product with a point is 1, with a direction 0.
const vec4 planeAtInfinity(0, 0, 0, 1);

// x 2^exponent. The call costs more than all else of a plane, and ordinary numbers do not need it.
double scaled(double x, int exponent) { return exponent == 0 ? x : std::scalbn(x, exponent); }

}  // namespace

std::array<vec4, 6> planesFromClip(const mat4& clipFromWorld) {
    requireFinite("planesFromClip", "the matrix", clipFromWorld);
    static constexpr std::array<const char*, 6> names{"left", "right", "bottom", "top", "near", "far"};

    // A point is inside where -w <= x, y, z <= w, that is where rows w + x, w - x, ... give a positive product.
    const mat4 rows = glm::transpose(clipFromWorld);
    std::array<vec4, 6> planes;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const vec4 &last = rows[3], &row = rows[static_cast<int>(i / 2)];
        const double sign = i % 2 == 0 ? 1 : -1;
        // Scales to numbers whose squares neither overflow nor vanish: any multiple of the rows has the same plane. The
        // distance has another size, and is brought to the normal's at the end, where nothing is computed with it any
        // more.
        const int exponent = scalingExponent(std::max(largestComponent(vec3(last)), largestComponent(vec3(row))));
        const int ofDistance = scalingExponent(std::max(std::abs(last.w), std::abs(row.w)));
        const vec3 ofLast = timesPowerOfTwo(vec3(last), -exponent), ofRow = timesPowerOfTwo(vec3(row), -exponent);
        const vec3 normal = ofLast + sign * ofRow;
        // At infinity: z and w have the same row but for the last number. The numbers as given are asked: what is left of them may
        // vanish where they are scaled
        if (vec3(last) == -sign * vec3(row) && ofRow != vec3(0) && last.w + sign * row.w > 0) {
            planes[i] = planeAtInfinity;
            continue;
        }
        const double length = glm::length(normal), terms = glm::length(ofLast) + glm::length(ofRow);
        if (!(length > 1e-10 * terms)) {
            throw Error("planesFromClip",
                        std::string("the ") + names[i] +
                            " plane's normal must not cancel; for an extreme far/near use perspectivePlanes",
                        numberText(length / terms) + " of its terms");
        }
        const double distance = (scaled(last.w, -ofDistance) + sign * scaled(row.w, -ofDistance)) / length;
        planes[i] = vec4(normal / length, scaled(distance, ofDistance - exponent));
        if (!isFinite(planes[i])) {
            throw Error("planesFromClip", std::string("the ") + names[i] + " plane must not overflow",
                        vectorText(last + sign * row));
        }
    }
    return planes;
}

std::array<vec4, 6> perspectivePlanes(double fovy, double aspect, double near, double far) {
    const bool isEndless = far == HUGE_VAL;
    const HalfAngle half = checkedHalfAngle("perspectivePlanes", fovy, aspect, near, isEndless ? 2 * near : far);

    // Side planes pass through the eye: their normals are (cos, 0, -sin) of half the angle, from its tangent.
    // Above 1 by its reciprocal, since the tangent may overflow.
    const auto inward = [](double t, double reciprocal) {
        if (t > 1) return vec2(reciprocal, -1) / std::hypot(reciprocal, 1.0);
        return vec2(1, -t) / std::hypot(1.0, t);
    };
    const vec2 side = inward(half.tangent * aspect, half.cotangent / aspect);
    const vec2 level = inward(half.tangent, half.cotangent);
    return {vec4(side.x, 0, side.y, 0),   vec4(-side.x, 0, side.y, 0),
            vec4(0, level.x, level.y, 0), vec4(0, -level.x, level.y, 0),
            vec4(0, 0, -1, -near),        isEndless ? planeAtInfinity : vec4(0, 0, 1, far)};
}

std::array<vec3, 8> viewVolumeCorners(const mat4& clipFromWorld) {
    requireFinite("viewVolumeCorners", "the matrix", clipFromWorld);
    const Elimination elimination(clipFromWorld);
    std::array<vec3, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i) {
        const vec4 clip((i & 1U) ? 1 : -1, (i & 2U) ? 1 : -1, (i & 4U) ? 1 : -1, 1);
        const std::optional<vec4> world = elimination.solve(clip);
        if (world) corners[i] = vec3(*world) / world->w;
        if (!world || !isFinite(corners[i])) {
            throw Error("viewVolumeCorners", "the matrix must have an inverse, and the volume an end",
                        world ? vectorText(*world) : "none for " + vectorText(clip));
        }
    }
    return corners;
}

vec3 ndcFromClip(const vec4& clip) {
    requireFinite("ndcFromClip", "the clip position", clip);
    if (!(clip.w > 0)) {
        throw Error("ndcFromClip", "w must be greater than 0 (clip before dividing)", vectorText(clip));
    }
    const vec3 ndc = vec3(clip) / clip.w;
    if (!isFinite(ndc)) {
        throw Error("ndcFromClip", "w must be large enough for the quotient not to overflow", vectorText(clip));
    }
    return ndc;
}

vec2 pixelFromNdc(const vec2& ndc, int width, int height) {
    requireFinite("pixelFromNdc", "the position", ndc);
    requirePositive("pixelFromNdc", "width", width);
    requirePositive("pixelFromNdc", "height", height);
    const vec2 pixel((ndc.x + 1) / 2 * width, (ndc.y + 1) / 2 * height);
    requireFinite("pixelFromNdc", "the pixel", pixel);
    return pixel;
}

vec2 pixelFromNdc(const vec3& ndc, int width, int height) { return pixelFromNdc(vec2(ndc), width, height); }

namespace {

// The differences are exact where they are small, as those of 1 and a quotient are not.
vec2 ndcFromPixel(std::string_view subject, const vec2& pixel, int width, int height) {
    requireFinite(subject, "the pixel", pixel);
    requirePositive(subject, "width", width);
    requirePositive(subject, "height", height);
    return {(2 * pixel.x - width) / width, (2 * pixel.y - height) / height};
}

}  // namespace

vec3 unProject(const vec2& pixel, double depth, const mat4& clipFromWorld, int width, int height) {
    requireFinite("unProject", "the matrix", clipFromWorld);
    requireFinite("unProject", "the depth", depth);
    const vec2 ndc = ndcFromPixel("unProject", pixel, width, height);
    const std::optional<vec4> world = Elimination(clipFromWorld).solve(vec4(ndc, 2 * depth - 1, 1));
    const vec3 point = world ? vec3(*world) / world->w : vec3(HUGE_VAL);
    if (!isFinite(point)) {
        throw Error("unProject", "the matrix must have an inverse, and the depth must not be at infinity",
                    world ? vectorText(*world) : "depth " + numberText(depth));
    }
    return point;
}

vec3 directionThroughPixel(const vec2& pixel, const mat4& clipFromWorld, int width, int height) {
    requireFinite("directionThroughPixel", "the matrix", clipFromWorld);
    const vec2 ndc = ndcFromPixel("directionThroughPixel", pixel, width, height);
    // Points drawn in the pixel's column have x - ndc.x w = 0, those in its row y - ndc.y w = 0; by rows of a size of 1
    const mat4 rows = glm::transpose(clipFromWorld);
    const vec3 column = scaledForSquares(vec3(rows[0] - ndc.x * rows[3]));
    const vec3 row = scaledForSquares(vec3(rows[1] - ndc.y * rows[3]));
    const vec3 along = accurateCross(column, row), z(rows[2]), w(rows[3]);
    if (along == vec3(0)) {
        throw Error("directionThroughPixel", "the matrix must keep rows and columns of pixels apart",
                    vectorText(column) + " and " + vectorText(row));
    }
    // Away from the eye w grows; of a parallel projection, whose w stays, the depth does
    const double grows = glm::dot(w, along) / (glm::length(w) * glm::length(along));
    const double deeper = std::abs(grows) > 1e-12 ? grows : glm::dot(z, along);
    if (deeper == 0 || !isFinite(deeper) || !isFinite(along)) {
        throw Error("directionThroughPixel", "the matrix must tell near from far", vectorText(along));
    }
    return deeper < 0 ? -unit(along) : unit(along);
}

}  // namespace mv
