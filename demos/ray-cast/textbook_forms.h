// Rays against simple solids by the forms of a lecture's slides: what a first ray caster has. These forms lose digits,
// or answer NaN, where mv/geometry/ray.h and ray_forms.h do not. Slips of the slides are mended, unless a form is asked
// for as printed.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "mv/geometry/ray_forms.h"

namespace mv::textbook {

enum class Print { mended, asPrinted };

// t = -(A x0 + B y0 + C z0 + D) / (A x + B y + C z). As printed, the numerator has lost A, B and C.
template <typename T>
std::optional<T> plane(const RayOf<T>& ray, const glm::vec<4, T>& abcd, Print print = Print::mended) {
    const glm::vec<3, T> normal(abcd), factors = print == Print::asPrinted ? glm::vec<3, T>(1) : normal;
    const T t = -(glm::dot(factors, ray.origin) + abcd.w) / glm::dot(normal, ray.direction);
    if (!(t > 0)) return {};
    return t;
}

// t = (<n, q0> - <n, p0>) / <n, v>
template <typename T>
std::optional<T> plane(const RayOf<T>& ray, const glm::vec<3, T>& point, const glm::vec<3, T>& normal) {
    const T t = (glm::dot(normal, point) - glm::dot(normal, ray.origin)) / glm::dot(normal, ray.direction);
    if (!(t > 0)) return {};
    return t;
}

// The point in the plane, then its barycentrics in the projection along the normal's largest component, here z:
//     l1 = ((b_y - c_y)(x - c_x) - (b_x - c_x)(y - c_y)) / N,     N = (a_x - c_x)(b_y - c_y) - (b_x - c_x)(a_y - c_y)
//     l2 = (-(a_y - c_y)(x - c_x) + (a_x - c_x)(y - c_y)) / N,    l3 = 1 - l1 - l2
// As printed, the + in l2 is a -.
template <typename T>
std::optional<TriangleHit<T>> triangle(const RayOf<T>& ray, const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                                       const glm::vec<3, T>& c, Print print = Print::mended) {
    const T sign = print == Print::asPrinted ? T(-1) : T(1);
    const glm::vec<3, T> normal = glm::normalize(glm::cross(b - a, c - a));
    const auto t = plane(ray, a, normal);
    if (!t) return {};
    const int axis = droppedAxis(normal);
    const glm::vec<2, T> p = without(axis, ray.at(*t) - c), ac = without(axis, a - c), bc = without(axis, b - c);
    const T below = ac.x * bc.y - bc.x * ac.y;
    const T first = (bc.y * p.x - bc.x * p.y) / below, second = (-ac.y * p.x + sign * ac.x * p.y) / below;
    const T third = 1 - first - second;
    if (!(first >= 0 && second >= 0 && third >= 0)) return {};
    return TriangleHit<T>{*t, first, second, third};
}

// Crossings of a ray along x with the polygon's edges, each with s in 0..1: a corner at the height of the point is counted
// with both of its edges.
template <typename T>
bool isInside(std::span<const glm::vec<2, T>> corners, const glm::vec<2, T>& point) {
    int crossings = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec<2, T>&from = corners[i], &to = corners[(i + 1) % corners.size()];
        const T s = (point.y - from.y) / (to.y - from.y);
        if (s >= 0 && s <= 1 && from.x + s * (to.x - from.x) > point.x) ++crossings;
    }
    return crossings % 2 == 1;
}

// D = (2 <v, f>)^2 - 4 <v, v> (<f, f> - r^2), f = p0 - c: the first root at t > 0.
template <typename T>
std::optional<T> sphere(const RayOf<T>& ray, const glm::vec<3, T>& center, T radius) {
    const glm::vec<3, T> f = ray.origin - center;
    const T a = glm::dot(ray.direction, ray.direction), b = 2 * glm::dot(ray.direction, f);
    const T discriminant = b * b - 4 * a * (glm::dot(f, f) - radius * radius);
    if (discriminant < 0) return {};
    const T root = std::sqrt(discriminant), near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
    if (!(far > 0)) return {};
    return near > 0 ? near : far;
}

// t1 = (a - x0) / v, t2 = (b - x0) / v for each axis; the last entry before the first exit. 0/0 where v is 0 and the origin
// on a slab's plane: the comparisons with NaN decide then.
template <typename T>
std::optional<RayInterval<T>> box(const RayOf<T>& ray, const glm::vec<3, T>& lo, const glm::vec<3, T>& hi) {
    const glm::vec<3, T> one = (lo - ray.origin) / ray.direction, two = (hi - ray.origin) / ray.direction;
    const glm::vec<3, T> in = glm::min(one, two), out = glm::max(one, two);
    const T near = std::max({in.x, in.y, in.z}), far = std::min({out.x, out.y, out.z});
    if (!(near <= far) || far < 0) return {};
    return RayInterval<T>{near, far};
}

}  // namespace mv::textbook
