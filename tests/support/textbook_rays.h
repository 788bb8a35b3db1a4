// Intersections as textbooks print them. They fail where mv/geometry/ray.h does not: the tests show where, and the
// benchmark what the difference costs.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "mv/geometry/ray.h"

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

// Woop, Benthin and Wald's as published (2013), in double: t by the weights of the corners, and a hit where it is above 0.
inline std::optional<TriangleHit<double>> publishedWatertight(const Ray& ray, const vec3& a, const vec3& b,
                                                              const vec3& c) {
    const vec3 d = glm::abs(ray.direction);
    const int z = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2), x = (z + 1) % 3, y = (z + 2) % 3;
    const auto sheared = [&](const vec3& corner) {
        const vec3 way = corner - ray.origin;
        const double along = way[z] / ray.direction[z];
        return vec3(way[x] - ray.direction[x] * along, way[y] - ray.direction[y] * along, along);
    };
    const vec3 ofA = sheared(a), ofB = sheared(b), ofC = sheared(c);
    const double u = ofC.x * ofB.y - ofC.y * ofB.x, v = ofA.x * ofC.y - ofA.y * ofC.x,
                 w = ofB.x * ofA.y - ofB.y * ofA.x, sum = u + v + w;
    if ((std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) || sum == 0) return {};
    const double t = (u * ofA.z + v * ofB.z + w * ofC.z) / sum;
    if (!(t > 0)) return {};
    return TriangleHit<double>{t, u / sum, v / sum, w / sum};
}

}  // namespace mv::test
