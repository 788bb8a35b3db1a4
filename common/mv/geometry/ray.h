// Rays against the simple solids, each in the form that keeps its accuracy where the textbook's loses it.
//
// Templates on the scalar, compiled for float and double: double is what the library computes in, float what a GPU
// has, and a study can show what lies between them. A ray with NaN, infinity or direction 0 meets nothing.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "mv/math/robust.h"
#include "mv/math/types.h"

namespace mv {

// The points origin + t direction, t >= 0. The direction need not have unit length: t counts in its lengths.
template <typename T>
struct RayOf {
    glm::vec<3, T> origin{0, 0, 0};
    glm::vec<3, T> direction{0, 0, -1};
    glm::vec<3, T> at(T t) const { return origin + t * direction; }
};
using Ray = RayOf<double>;

// The part of the line within a solid, near <= far and far >= 0; near is negative where the ray starts inside.
template <typename T>
struct RayInterval {
    T near = 0, far = 0;
};

// The meeting of the ray with the plane of the points with dot(plane.xyz, p) + plane.w = 0, from either side, t >= 0.
// None where it runs parallel to the plane, in it or beside it.
template <typename T>
std::optional<T> intersectPlane(const RayOf<T>& ray, const glm::vec<4, T>& plane);

// The part of the ray inside the sphere. The discriminant comes from the line's distance to the centre and the roots
// without a difference of near numbers, so that a small or distant sphere is neither missed nor hit beside itself;
// from b*b - 4ac in float every ray that comes within some radii of a unit sphere 1e4 away is a hit or a miss by chance.
// Needs a radius above 0; with another one the answer is none. Trap: for a huge sphere under the eye (the earth) in
// float, t is only as good as the coordinates, 1e-7 of the radius. Near its outline, a sphere's t is as good as the
// discriminant, a sum of squares of the coordinates: what rounding them would change.
// Source: Haines, Gunther, Akenine-Moller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems (2019).
template <typename T>
std::optional<RayInterval<T>> intersectSphere(const RayOf<T>& ray, const glm::vec<3, T>& center, T radius);

// The part of the ray inside the closed box lo..hi along the axes; a box may be flat. A ray in the plane of a face
// (a direction with zeros) is inside as long as it is within the face. Source: Kay and Kajiya's slabs (1986).
template <typename T>
std::optional<RayInterval<T>> intersectBox(const RayOf<T>& ray, const glm::vec<3, T>& lo, const glm::vec<3, T>& hi);

template <typename T>
struct TriangleHit {
    T t = 0;
    T a = 0, b = 0, c = 0;  // weights of the corners, at least 0, of sum 1: the point is a A + b B + c C
};

// One ray against many triangles, from either side, t > 0. Watertight: of two triangles with a common edge, by the same
// coordinates, at least one is hit by a ray towards the edge, and so at a corner. Rounding decides for a triangle
// without area whether it is hit, and where: leave out before what areOnOneLine(), as the ray caster does. So it is
// with one that is seen exactly from the side; there its neighbours are hit. Coordinates whose products would leave the
// range of T are not supported. A triangle in whose plane the ray begins, but for a few roundings of the ways to its
// corners, is not met: so a ray that begins besideSurface() does not meet what it leaves, however slender that is.
// Source: Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013; a bound on t as of Pharr, Jakob
// and Humphreys, "Physically based rendering" (2023), "Avoiding intersections behind ray origins", but on the distance
// from the plane.
template <typename T>
class TriangleTest {
  public:
    explicit TriangleTest(const RayOf<T>& ray);
    std::optional<TriangleHit<T>> operator()(const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                                             const glm::vec<3, T>& c) const;

  private:
    template <int Z>
    std::optional<TriangleHit<T>> hit(const glm::vec<3, T>& a, const glm::vec<3, T>& b, const glm::vec<3, T>& c) const;

    glm::vec<3, T> origin_;
    int z_ = 0;  // the direction's largest component
    T shearX_ = 0, shearY_ = 0, scaleZ_ = 0;
};

// True only where three points are on one line, or two of them the same; false also where a difference is rounded, so that
// nobody knows.
template <typename T>
bool areOnOneLine(const glm::vec<3, T>& a, const glm::vec<3, T>& b, const glm::vec<3, T>& c);

// TriangleTest for one triangle, and none where areOnOneLine(a, b, c).
template <typename T>
std::optional<TriangleHit<T>> intersectTriangle(const RayOf<T>& ray, const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                                                const glm::vec<3, T>& c) {
    const auto hit = TriangleTest<T>(ray)(a, b, c);
    if (hit && areOnOneLine(a, b, c)) return {};
    return hit;
}

// The start of a ray in `direction` that leaves a surface at `point`: off it along the unit vector `normal`, to the
// side that the direction leads to, by that many roundings of the largest coordinate in `size`, along each axis. So far
// may the point, and what the next ray computes, be off the true surface; no fixed epsilon, so it serves at every
// scale. For a triangle: 8, and the largest sizes of its corners' coordinates; TriangleTest then meets neither it again
// nor a neighbour in its plane. Trap: roundings of the coordinates along the normal alone, which are 0 in the plane y =
// 0, are not enough: the next ray's test mixes all three.
inline vec3 besideSurface(const vec3& point, const vec3& normal, const vec3& direction, const vec3& size,
                          double roundings) {
    const double rounding = std::numeric_limits<double>::epsilon() * largestComponent(size);
    const double off = roundings * glm::dot(glm::abs(normal), vec3(rounding));
    return glm::dot(normal, direction) < 0 ? point - off * normal : point + off * normal;
}

// ---- inline, for the sake of the ray caster

// p*q - r*s with the sign of the exact difference, and 0 only where that is 0.
inline double signedDifference(double p, double q, double r, double s) {
    if ((p == 0 || q == 0) && (r == 0 || s == 0)) return 0;  // a ray at the very corner
    return differenceOfProducts(p, q, r, s);
}
inline float signedDifference(float p, float q, float r, float s) {
    // Products of floats are exact in double.
    return static_cast<float>(static_cast<double>(p) * q - static_cast<double>(r) * s);
}

// Component i of v, known when compiling: x, y, z, and again x, y.
template <int I, typename T>
T component(const glm::vec<3, T>& v) {
    if constexpr (I % 3 == 0) return v.x;
    if constexpr (I % 3 == 1) return v.y;
    if constexpr (I % 3 == 2) return v.z;
}

// p x q, each component with the sign of the exact one.
template <typename T>
glm::vec<3, T> crossWithSigns(const glm::vec<3, T>& p, const glm::vec<3, T>& q) {
    return {signedDifference(p.y, q.z, p.z, q.y), signedDifference(p.z, q.x, p.x, q.z),
            signedDifference(p.x, q.y, p.y, q.x)};
}

template <typename T>
bool areOnOneLine(const glm::vec<3, T>& a, const glm::vec<3, T>& b, const glm::vec<3, T>& c) {
    const glm::vec<3, T> ab = b - a, ac = c - a;
    const auto isExact = [](T difference, T p, T q) {
        const T back = difference - p;  // Knuth's sum without error: what was rounded off comes out
        return (p - (difference - back)) - (q + back) == 0;
    };
    for (int i = 0; i < 3; ++i) {
        if (!isExact(ab[i], b[i], a[i]) || !isExact(ac[i], c[i], a[i])) return false;
    }
    return crossWithSigns(ab, ac) == glm::vec<3, T>(0);
}

// Six times the volume between a triangle and a point near it, by the edges from one corner and the way from the point to that
// corner; 0 where the point may as well lie in the plane. The sum of the weights' products, which is the same on paper, has
// the sign of a rounding where a slender triangle is near: each weight is a small difference of large products. Here a rounding
// of an edge counts as if the plane were moved by it. `p` and `q` are the parts of the edges at which the ray passes; the
// fewer of them, the less their roundings count.
template <typename T>
T volumeNearPlane(const glm::vec<3, T>& toCorner, const glm::vec<3, T>& edgeP, T p, const glm::vec<3, T>& edgeQ, T q) {
    const glm::vec<3, T> normal = crossWithSigns(edgeP, edgeQ);
    const T volume = -glm::dot(normal, toCorner);
    // Seven halves of an epsilon for the way, the normal, the products and their sum, and one for each edge
    const glm::vec<3, T> sizes = glm::abs(toCorner) + p * glm::abs(edgeP) + q * glm::abs(edgeQ);
    const T bound = 4 * std::numeric_limits<T>::epsilon() * glm::dot(glm::abs(normal), sizes);
    return std::abs(volume) > bound ? volume : 0;
}

template <typename T>
TriangleTest<T>::TriangleTest(const RayOf<T>& ray) : origin_(ray.origin) {
    const glm::vec<3, T>& d = ray.direction;
    const T sizeX = std::abs(d.x), sizeY = std::abs(d.y), sizeZ = std::abs(d.z);
    z_ = sizeX > sizeY ? (sizeX > sizeZ ? 0 : 2) : (sizeY > sizeZ ? 1 : 2);
    const T x = z_ == 0 ? d.y : z_ == 1 ? d.z : d.x;
    const T y = z_ == 0 ? d.z : z_ == 1 ? d.x : d.y;
    const T z = z_ == 0 ? d.x : z_ == 1 ? d.y : d.z;
    shearX_ = x / z;
    shearY_ = y / z;
    scaleZ_ = 1 / z;
}

template <typename T>
std::optional<TriangleHit<T>> TriangleTest<T>::operator()(const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                                                          const glm::vec<3, T>& c) const {
    return z_ == 0 ? hit<0>(a, b, c) : z_ == 1 ? hit<1>(a, b, c) : hit<2>(a, b, c);
}

template <typename T>
template <int Z>
std::optional<TriangleHit<T>> TriangleTest<T>::hit(const glm::vec<3, T>& cornerA, const glm::vec<3, T>& cornerB,
                                                   const glm::vec<3, T>& cornerC) const {
    // Sheared so that the ray becomes the line x = y = 0
    const glm::vec<3, T> fromA = cornerA - origin_, fromB = cornerB - origin_, fromC = cornerC - origin_;
    const T za = component<Z>(fromA), zb = component<Z>(fromB), zc = component<Z>(fromC);
    const T xa = component<Z + 1>(fromA) - shearX_ * za, ya = component<Z + 2>(fromA) - shearY_ * za;
    const T xb = component<Z + 1>(fromB) - shearX_ * zb, yb = component<Z + 2>(fromB) - shearY_ * zb;
    const T xc = component<Z + 1>(fromC) - shearX_ * zc, yc = component<Z + 2>(fromC) - shearY_ * zc;

    // On which side of each edge the ray passes. The neighbour across the edge computes the same number with the other
    // sign, bit for bit, and what is not 0 has the right sign: that makes the test watertight.
    T u = xc * yb - yc * xb, v = xa * yc - ya * xc, w = xb * ya - yb * xa;
    const auto passesBy = [&] { return std::min(std::min(u, v), w) < 0 && std::max(std::max(u, v), w) > 0; };
    if (passesBy()) return {};
    if (u == 0 || v == 0 || w == 0) [[unlikely]] {
        if (u == 0) u = signedDifference(xc, yb, yc, xb);
        if (v == 0) v = signedDifference(xa, yc, ya, xc);
        if (w == 0) w = signedDifference(xb, ya, yb, xa);
        if (passesBy()) return {};
    }
    const T sum = u + v + w;
    if (sum == 0) return {};
    T volume = u * za + v * zb + w * zc;
    // Corners before the origin and behind it: from the corner that weighs most, which is as near to the ray as any
    if (std::min(std::min(za, zb), zc) <= 0 && std::max(std::max(za, zb), zc) >= 0) {
        const T a = u / sum, b = v / sum, c = w / sum;
        if (a >= b && a >= c) {
            volume = volumeNearPlane(fromA, cornerB - cornerA, b, cornerC - cornerA, c);
        } else if (b >= c) {
            volume = volumeNearPlane(fromB, cornerC - cornerB, c, cornerA - cornerB, a);
        } else {
            volume = volumeNearPlane(fromC, cornerA - cornerC, a, cornerB - cornerC, b);
        }
    }
    const T t = scaleZ_ * volume / sum;
    if (!(t > 0 && t <= std::numeric_limits<T>::max())) return {};  // also where there was a NaN
    return TriangleHit<T>{t, u / sum, v / sum, w / sum};
}

template <typename T>
std::optional<RayInterval<T>> intersectSphere(const RayOf<T>& ray, const glm::vec<3, T>& center, T radius) {
    const glm::vec<3, T> f = ray.origin - center, &d = ray.direction;
    const T a = glm::dot(d, d);
    // |f x d| is the line's distance from the centre, times |d|; b*b - a*c is the same on paper.
    const glm::vec<3, T> miss = glm::cross(f, d);
    const T discriminant = a * (radius * radius) - glm::dot(miss, miss);
    if (!(discriminant >= 0 && radius > 0 && a > 0)) return {};
    // One root adds numbers of one sign, and the other one follows from the product of both, c/a. For floats their products'
    // sums are kept in double, which costs nothing and saves the sphere far away its last places.
    const vec3 from(f), along(d);
    const double r = static_cast<double>(radius), root = static_cast<double>(std::sqrt(discriminant));
    const double b = -glm::dot(from, along), c = glm::dot(from, from) - r * r;
    const double q = b + std::copysign(root, b);
    T near = static_cast<T>(c / q), far = static_cast<T>(q / static_cast<double>(a));
    if (q == 0) near = far = 0;  // touches the sphere where the ray starts
    if (near > far) std::swap(near, far);
    if (!(far >= near && far >= 0 && far <= std::numeric_limits<T>::max())) return {};  // also where there was a NaN
    return RayInterval<T>{near, far};
}

}  // namespace mv
