// Intersections as textbooks print them. They fail where mv/geometry/ray.h does not: the tests show where, and the
// benchmark what the difference costs.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "mv/geometry/ray.h"
#include "ray-trace/leaving.h"

namespace mv::test {

// The quadratic formula: b*b - a*c loses every digit when the sphere is far away.
template <typename T>
std::optional<RayInterval<T>> textbookSphere(const RayOf<T>& ray, const glm::vec<3, T>& center, T radius) {
    const glm::vec<3, T> f = ray.origin - center;
    const T a = glm::dot(ray.direction, ray.direction), b = glm::dot(f, ray.direction);
    const T discriminant = b * b - a * (glm::dot(f, f) - radius * radius);
    if (discriminant < 0) return {};
    const T root = std::sqrt(discriminant);
    const RayInterval<T> interval{(-b - root) / a, (-b + root) / a};
    if (interval.far < 0) return {};
    return interval;
}

// Moller and Trumbore (1997), with the epsilon that it is usually copied with. Neighbours compute their common edge from
// different corners, so that rounding can leave a gap between them.
template <typename T>
std::optional<TriangleHit<T>> textbookTriangle(const RayOf<T>& ray, const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                                               const glm::vec<3, T>& c, T epsilon = T(1e-6)) {
    const glm::vec<3, T> ab = b - a, ac = c - a;
    const glm::vec<3, T> p = glm::cross(ray.direction, ac);
    const T determinant = glm::dot(ab, p);
    if (std::abs(determinant) <= epsilon) return {};
    const glm::vec<3, T> s = ray.origin - a;
    const T v = glm::dot(s, p) / determinant;
    if (v < 0 || v > 1) return {};
    const glm::vec<3, T> q = glm::cross(s, ab);
    const T w = glm::dot(ray.direction, q) / determinant;
    if (w < 0 || v + w > 1) return {};
    const T t = glm::dot(ac, q) / determinant;
    if (!(t > 0)) return {};
    return TriangleHit<T>{t, 1 - v - w, v, w};
}

}  // namespace mv::test
