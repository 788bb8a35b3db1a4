// Rays against the simple solids, each in the form that keeps its accuracy where the textbook's loses it.
//
// Templates on the scalar, compiled for float and double: double is what the library computes in, float what a GPU
// has, and a study can show what lies between them. A ray with NaN, infinity or direction 0 meets nothing.
#pragma once
#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>

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

// Where the ray meets the plane of the points with dot(plane.xyz, p) + plane.w = 0, from either side, t >= 0. None
// where it runs parallel to the plane, in it or beside it.
template <typename T>
std::optional<T> intersectPlane(const RayOf<T>& ray, const glm::vec<4, T>& plane);

// Where the ray is inside the sphere. The discriminant comes from the line's distance to the centre and the roots
// without a difference of near numbers, so that a small or distant sphere is neither missed nor hit beside itself;
// from b*b - 4ac in float every ray that comes within some radii of a unit sphere 1e4 away is a hit or a miss by chance.
// Needs a radius above 0; with another one the answer is none. Trap: for a huge sphere under the eye (the earth) in
// float, t is only as good as the coordinates, 1e-7 of the radius.
// Source: Haines, Gunther, Akenine-Moller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems (2019).
template <typename T>
std::optional<RayInterval<T>> intersectSphere(const RayOf<T>& ray, const glm::vec<3, T>& center, T radius);

// Where the ray is inside the closed box lo..hi along the axes; a box may be flat. A ray in the plane of a face
// (a direction with zeros) is inside as long as it is within the face. Source: Kay and Kajiya's slabs (1986).
template <typename T>
std::optional<RayInterval<T>> intersectBox(const RayOf<T>& ray, const glm::vec<3, T>& lo, const glm::vec<3, T>& hi);

template <typename T>
struct TriangleHit {
    T t = 0;
    T a = 0, b = 0, c = 0;  // weights of the corners, at least 0, of sum 1: the point is a A + b B + c C
};

// One ray against many triangles, from either side, t > 0. Watertight: of two triangles with a common edge, by the same
// coordinates, at least one is hit by a ray towards the edge, and so at a corner. Triangles without area, and those
// seen exactly from the side, are never hit. Coordinates whose products would leave the range of T are not supported.
// Source: Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013.
template <typename T>
class TriangleTest {
  public:
    explicit TriangleTest(const RayOf<T>& ray);
    std::optional<TriangleHit<T>> operator()(const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                                             const glm::vec<3, T>& c) const;

  private:
    struct Sheared {
        T x, y, z;
    };
    Sheared sheared(const glm::vec<3, T>& p) const;

    glm::vec<3, T> origin_;
    int x_, y_, z_;  // z_ is the direction's largest component
    T shearX_, shearY_, scaleZ_;
};

template <typename T>
std::optional<TriangleHit<T>> intersectTriangle(const RayOf<T>& ray, const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                                                const glm::vec<3, T>& c) {
    return TriangleTest<T>(ray)(a, b, c);
}

// ---- TriangleTest, inline for the sake of the ray caster

// p*q - r*s with the sign of the exact difference, and 0 only where that is 0.
inline double signedDifference(double p, double q, double r, double s) { return differenceOfProducts(p, q, r, s); }
inline float signedDifference(float p, float q, float r, float s) {
    // Products of floats are exact in double.
    return static_cast<float>(static_cast<double>(p) * q - static_cast<double>(r) * s);
}

template <typename T>
TriangleTest<T>::TriangleTest(const RayOf<T>& ray) : origin_(ray.origin) {
    const glm::vec<3, T>& d = ray.direction;
    const T sizeX = std::abs(d.x), sizeY = std::abs(d.y), sizeZ = std::abs(d.z);
    z_ = sizeX > sizeY ? (sizeX > sizeZ ? 0 : 2) : (sizeY > sizeZ ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    const T* direction = &d.x;
    shearX_ = direction[x_] / direction[z_];
    shearY_ = direction[y_] / direction[z_];
    scaleZ_ = 1 / direction[z_];
}

// The point seen along the ray: the ray is the line x = y = 0 there, and z is its t.
template <typename T>
typename TriangleTest<T>::Sheared TriangleTest<T>::sheared(const glm::vec<3, T>& p) const {
    const T fromOrigin[3] = {p.x - origin_.x, p.y - origin_.y, p.z - origin_.z};
    const T z = fromOrigin[z_];
    return {fromOrigin[x_] - shearX_ * z, fromOrigin[y_] - shearY_ * z, scaleZ_ * z};
}

template <typename T>
std::optional<TriangleHit<T>> TriangleTest<T>::operator()(const glm::vec<3, T>& cornerA, const glm::vec<3, T>& cornerB,
                                                          const glm::vec<3, T>& cornerC) const {
    const Sheared a = sheared(cornerA), b = sheared(cornerB), c = sheared(cornerC);
    // On which side of each edge the ray passes. The neighbour across the edge computes the same number with the other
    // sign, bit for bit; that is what makes the test watertight.
    T u = c.x * b.y - c.y * b.x;
    T v = a.x * c.y - a.y * c.x;
    T w = b.x * a.y - b.y * a.x;
    if (u == 0 || v == 0 || w == 0) {
        u = signedDifference(c.x, b.y, c.y, b.x);
        v = signedDifference(a.x, c.y, a.y, c.x);
        w = signedDifference(b.x, a.y, b.y, a.x);
    }
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
    const T sum = u + v + w;
    if (sum == 0) return {};
    const T t = (u * a.z + v * b.z + w * c.z) / sum;
    if (!(t > 0 && t <= std::numeric_limits<T>::max())) return {};  // also where there was a NaN
    return TriangleHit<T>{t, u / sum, v / sum, w / sum};
}

}  // namespace mv
