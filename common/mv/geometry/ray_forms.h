// Rays against what a lecture on ray casting has and mv/geometry/ray.h has not: a plane by a point and its normal or by two
// vectors, a polygon, a parametric surface by Newton's method, and objects under a matrix.
//
// Templates on the scalar, as those. A ray with NaN, infinity or direction 0 meets nothing.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "mv/geometry/clip_segment.h"
#include "mv/geometry/ray.h"

namespace mv {

// The meeting of a ray with a surface that has two coordinates of its own: a plane corner + u along + v up, a surface
// r(u, v).
template <typename T>
struct SurfaceHit {
    T t = 0, u = 0, v = 0;
};

// 0 <= t, finite.
template <typename T>
bool isAhead(T t) {
    return t >= 0 && t <= std::numeric_limits<T>::max();
}

// The meeting of the ray with the plane through `point` with that normal, of any length; t >= 0. None where it runs
// parallel to it. The points are subtracted first, which keeps the digits that dot(n, q) - dot(n, p) loses far from the
// origin.
template <typename T>
std::optional<T> intersectPlane(const RayOf<T>& ray, const glm::vec<3, T>& point, const glm::vec<3, T>& normal) {
    const T t = glm::dot(normal, point - ray.origin) / glm::dot(normal, ray.direction);
    if (!isAhead(t)) return {};
    return t;
}

// The meeting of the ray with the plane corner + u along + v up: the system of three equations, by Cramer's rule; t >=
// 0, any u and v. None where the ray runs parallel to it, or `along` parallel to `up`.
template <typename T>
std::optional<SurfaceHit<T>> intersectPlane(const RayOf<T>& ray, const glm::vec<3, T>& corner,
                                            const glm::vec<3, T>& along, const glm::vec<3, T>& up) {
    const glm::vec<3, T> from = corner - ray.origin, normal = glm::cross(along, up);
    const T determinant = glm::dot(normal, ray.direction);
    const SurfaceHit<T> hit{glm::dot(normal, from) / determinant,
                            glm::dot(glm::cross(up, from), ray.direction) / determinant,
                            glm::dot(glm::cross(from, along), ray.direction) / determinant};
    if (!isAhead(hit.t) || !std::isfinite(hit.u) || !std::isfinite(hit.v)) return {};
    return hit;
}

// The axis (0: x, 1: y, 2: z) that is left out where a plane with that normal is projected onto two axes: the one along
// which the normal is longest, so that the projection has the largest area.
template <typename T>
int droppedAxis(const glm::vec<3, T>& normal) {
    const T x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}
// The other two components, in an order that keeps the turn.
template <typename T>
glm::vec<2, T> without(int axis, const glm::vec<3, T>& v) {
    return {v[(axis + 1) % 3], v[(axis + 2) % 3]};
}

// Whether the point is inside the polygon, convex or not, by the even-odd rule: edges to its right are counted, each
// half-open in y, so that of polygons that share their edges and cover a place each point is in exactly one. Refuses none:
// fewer than 3 corners hold nothing. A point exactly on an edge is inside or not by the side on which the polygon lies; which points
// are that is decided exactly, by orientation(), whose range of coordinates it has.
template <typename T>
bool isInside(std::span<const glm::vec<2, T>> corners, const glm::vec<2, T>& point) {
    bool inside = false;
    for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
        // Upwards, whichever way it is given, so that a neighbour computes the same number
        const bool rises = corners[before].y < corners[i].y;
        const glm::vec<2, T>&a = corners[rises ? before : i], &b = corners[rises ? i : before];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (orientation(vec2(a), vec2(b), vec2(point)) > 0) inside = !inside;
    }
    return inside;
}

// The meeting of the ray with a plane polygon of up to 16 corners, from either side; t >= 0. Its plane is that of the
// largest normal that the sum of cross products has (Newell), through the first corner. None for fewer than 3 corners,
// more than 16, or no area.
template <typename T>
std::optional<T> intersectPolygon(const RayOf<T>& ray, std::span<const glm::vec<3, T>> corners) {
    std::array<glm::vec<2, T>, 16> flat;
    if (corners.size() < 3 || corners.size() > flat.size()) return {};
    glm::vec<3, T> normal(0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    const auto t = intersectPlane(ray, corners[0], normal);
    if (!t) return {};
    const int axis = droppedAxis(normal);
    for (std::size_t i = 0; i < corners.size(); ++i) flat[i] = without(axis, corners[i]);
    const std::span<const glm::vec<2, T>> polygon(flat.data(), corners.size());
    if (!isInside(polygon, without(axis, ray.at(*t)))) return {};
    return t;
}

// The ray in an object's own space, by the inverse of the object's matrix. Its direction is not normalized: so t is the
// same number in both spaces, and the t's of several objects can be compared.
template <typename T>
RayOf<T> transformed(const RayOf<T>& ray, const glm::mat<4, 4, T>& objectFromWorld) {
    return {glm::vec<3, T>(objectFromWorld * glm::vec<4, T>(ray.origin, 1)),
            glm::vec<3, T>(objectFromWorld * glm::vec<4, T>(ray.direction, 0))};
}
// An object's normal in the world, not of unit length: normals go by the inverse transpose.
template <typename T>
glm::vec<3, T> normalToWorld(const glm::vec<3, T>& normal, const glm::mat<4, 4, T>& objectFromWorld) {
    return glm::transpose(glm::mat<3, 3, T>(objectFromWorld)) * normal;
}

// A surface's point and derivatives.
template <typename T>
struct SurfaceAt {
    glm::vec<3, T> point, alongU, alongV;
};

// Newton's method for r(u, v) = origin + t direction, from a guess: quadratic near a hit, and anywhere else no promise.
// The iteration ends where a step moves the point by less than 8 units in the last place of the larger coordinates.
// None where that does not come in 16 steps, the matrix has no inverse, or it ends outside of u, v = 0..1 or at t < 0.
template <typename T, class Surface>
std::optional<SurfaceHit<T>> intersectSurface(const RayOf<T>& ray, const Surface& surface, SurfaceHit<T> guess) {
    constexpr T unit = 8 * std::numeric_limits<T>::epsilon();
    for (int step = 0; step < 16; ++step) {
        const SurfaceAt<T> at = surface(guess.u, guess.v);
        // The tangent plane, with u and v counted from the guess
        const glm::vec<3, T> normal = glm::cross(at.alongU, at.alongV), from = at.point - ray.origin;
        const T determinant = glm::dot(normal, ray.direction);
        const SurfaceHit<T> move{glm::dot(normal, from) / determinant,
                                 glm::dot(glm::cross(at.alongV, from), ray.direction) / determinant,
                                 glm::dot(glm::cross(from, at.alongU), ray.direction) / determinant};
        guess = {move.t, guess.u + move.u, guess.v + move.v};
        if (!std::isfinite(guess.t) || !(std::abs(guess.u) < 8 && std::abs(guess.v) < 8)) return {};
        const T moved = std::abs(move.u) * glm::length(at.alongU) + std::abs(move.v) * glm::length(at.alongV);
        if (moved > unit * (glm::length(at.point) + glm::length(ray.origin))) continue;
        if (!isAhead(guess.t) || std::min(guess.u, guess.v) < 0 || std::max(guess.u, guess.v) > 1) return {};
        return guess;
    }
    return {};
}

// The nearest of those that Newton's method finds from the triangles of a grid of `cells` x `cells`, 1 to 64, that the ray
// meets, made larger by a third each. A grid that is too coarse misses a part that bulges beyond these triangles.
template <typename T, class Surface>
std::optional<SurfaceHit<T>> intersectSurfaceFromGrid(const RayOf<T>& ray, const Surface& surface, int cells) {
    std::optional<SurfaceHit<T>> nearest;
    if (cells < 1 || cells > 64) return nearest;
    const auto side = static_cast<std::size_t>(cells);
    const T size = 1 / static_cast<T>(cells), slack = static_cast<T>(1) / 3;
    std::array<glm::vec<3, T>, 65> lower, upper;  // two rows of the grid's points
    const auto place = [&](std::size_t i) { return static_cast<T>(i) * size; };
    for (std::size_t i = 0; i <= side; ++i) upper[i] = surface(place(i), static_cast<T>(0)).point;
    for (std::size_t j = 0; j < side; ++j) {
        std::swap(lower, upper);
        for (std::size_t i = 0; i <= side; ++i) upper[i] = surface(place(i), place(j + 1)).point;
        for (std::size_t i = 0; i < side; ++i) {
            const T u = place(i), v = place(j);
            const glm::vec<3, T>&a = lower[i], &b = lower[i + 1], &c = upper[i], &d = upper[i + 1];
            for (const bool isUpper : {false, true}) {
                const auto hit = isUpper ? intersectPlane(ray, d, c - d, b - d) : intersectPlane(ray, a, b - a, c - a);
                if (!hit || std::min(hit->u, hit->v) < -slack || hit->u + hit->v > 1 + slack) continue;
                const SurfaceHit<T> guess{hit->t, isUpper ? u + size * (1 - hit->u) : u + size * hit->u,
                                          isUpper ? v + size * (1 - hit->v) : v + size * hit->v};
                const auto found = intersectSurface(ray, surface, guess);
                if (found && (!nearest || found->t < nearest->t)) nearest = found;
            }
        }
    }
    return nearest;
}

}  // namespace mv
