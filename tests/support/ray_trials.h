// Rays whose answer is known, for those tests and rows of docs/stability.md that compare mv/geometry/ray.h with the forms
// of textbook_rays.h. `Exact` is what the answers are computed in: double, long double, or Wide.
#pragma once
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mv/geometry/check.h"
#include "mv/geometry/ray.h"
#include "mv/geometry/shapes.h"
#include "support/random.h"

namespace mv::test {

// ---- spheres

template <typename Exact>
Exact exactDot(const vec3& a, const vec3& b) {
    return Exact(a.x) * Exact(b.x) + Exact(a.y) * Exact(b.y) + Exact(a.z) * Exact(b.z);
}

struct SphereTrial {
    RayOf<float> ray;
    bool hits = false;
    double near = 0;  // t of the first point, where it hits
};

// Rays from `distance` away towards a unit sphere about the origin, half of them inside half its radius and half beside it
// by half of that: whatever rounding the float coordinates have, there is no doubt about any of them.
template <typename Exact>
std::vector<SphereTrial> sphereTrials(float distance, int count) {
    Random random(18);
    std::vector<SphereTrial> trials;
    for (int i = 0; i < count; ++i) {
        const vec3 towards = random.direction();
        const vec3 across = glm::normalize(glm::cross(towards, random.direction()));
        const bool hits = i % 2 == 0;
        const vec3 aim = across * (hits ? random.number(0, 0.5) : random.number(1.5, 3));
        const fvec3 origin(-static_cast<double>(distance) * towards);
        const fvec3 direction(glm::normalize(aim - vec3(origin)));
        // Of these floats; the miss distance by a cross product, which does not cancel
        const vec3 d(direction), f(origin);
        Exact missed = 0;  // squared, times the direction's length squared
        for (int axis = 0; axis < 3; ++axis) {
            const int next = (axis + 1) % 3, last = (axis + 2) % 3;
            const Exact part = Exact(f[next]) * Exact(d[last]) - Exact(f[last]) * Exact(d[next]);
            missed += part * part;
        }
        using std::sqrt;
        const Exact length = exactDot<Exact>(d, d);
        const auto miss = static_cast<double>(sqrt(missed / length));
        if (hits != (miss < 1) || std::abs(miss - 1) < 0.25) continue;  // the float direction went astray: at 1e6
        SphereTrial trial{{origin, direction}, hits};
        if (hits) trial.near = static_cast<double>((-exactDot<Exact>(f, d) - sqrt(length - missed)) / length);
        trials.push_back(trial);
    }
    return trials;
}

struct SphereErrors {
    int falseHits = 0, misses = 0;
    double largestUlps = 0;  // of t, where both agree on a hit
};

template <typename Intersect>
SphereErrors sphereErrors(const std::vector<SphereTrial>& trials, Intersect intersect) {
    SphereErrors errors;
    for (const SphereTrial& trial : trials) {
        const auto found = intersect(trial.ray, fvec3(0), 1.0F);
        if (!found) {
            errors.misses += trial.hits ? 1 : 0;
        } else if (!trial.hits) {
            ++errors.falseHits;
        } else {
            const auto near = static_cast<float>(trial.near);
            const double ulp = static_cast<double>(std::nextafter(near, HUGE_VALF)) - static_cast<double>(near);
            errors.largestUlps =
                std::max(errors.largestUlps, std::abs(static_cast<double>(found->near) - trial.near) / ulp);
        }
    }
    return errors;
}

// The eye 1 above a ball of whole-numbered radius, looking down, at most 45 degrees aside: the largest relative error of t
// in 1000 rays. `T` is what the ray is in.
template <typename Exact, typename T, typename Intersect>
double groundError(double radius, Intersect intersect) {
    Random random(19);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        // Of a float, so that the ray is the same in every T
        const double aside = static_cast<double>(static_cast<float>(random.number(-1, 1)));
        const RayOf<T> ray{{0, T(radius + 1), 0}, {T(aside), -1, 0}};
        // With c = |f|^2 - r^2 = 2r + 1, exact, the smaller root is c/q
        using std::sqrt;
        const Exact a = Exact(aside) * Exact(aside) + 1, b = Exact(radius) + 1, c = 2 * Exact(radius) + 1;
        const auto exact = static_cast<double>(c / (b + sqrt(b * b - a * c)));
        const auto found = intersect(ray, glm::vec<3, T>(0), T(radius));
        worst = std::max(worst, found ? std::abs(static_cast<double>(found->near) / exact - 1) : 1);
    }
    return worst;
}

// ---- triangles

enum class Aim { anywhere, corner, edge };

// How many of so many rays from within a sphere with bumps, closed, and seen whole from everywhere within half its radius,
// meet none of its triangles.
template <typename T, typename Intersect>
int missedRays(Aim aim, int rays, Intersect intersect) {
    const MeshData smooth = sphere(1, 16, 9);
    std::vector<fvec3> positions = smooth.positions;
    const auto triangles = trianglesOf(smooth);
    // Of its position alone, so that vertices at the same place stay together
    for (fvec3& p : positions) p *= 1 + 0.2F * std::sin(37 * p.x + 91 * p.y + 53 * p.z);
    Random random(20);
    int count = 0;
    for (int i = 0; i < rays; ++i) {
        const auto chosen = static_cast<std::size_t>(random.number(0, static_cast<double>(triangles.size())));
        const auto& triangle = triangles[chosen];
        const vec3 a(positions[triangle[0]]), b(positions[triangle[1]]);
        const fvec3 origin(random.point(0.25));
        const double part = random.number(0, 1);
        const vec3 towards = aim == Aim::corner ? a : aim == Aim::edge ? a + part * (b - a) : random.point(1);
        // As a program would: in the numbers it computes with
        const glm::vec<3, T> direction = glm::vec<3, T>(towards) - glm::vec<3, T>(origin);
        const RayOf<T> ray{glm::vec<3, T>(origin), direction};
        bool met = false;
        for (std::size_t step = 0; step < triangles.size() && !met; ++step) {
            const auto& [j, k, l] = triangles[(chosen + step) % triangles.size()];  // the likely one first
            met =
                intersect(ray, glm::vec<3, T>(positions[j]), glm::vec<3, T>(positions[k]), glm::vec<3, T>(positions[l]))
                    .has_value();
        }
        count += met ? 0 : 1;
    }
    return count;
}

// How many of 3000 rays towards points of triangles without area hit them: the corners are on a line of whole numbers, all
// different (one in three), two of them the same, or all.
template <typename Intersect>
int hitsOfNothing(Intersect intersect) {
    Random random(22);
    const auto whole = [&] {
        const vec3 p = random.point(100);
        return vec3(std::floor(p.x), std::floor(p.y), std::floor(p.z));
    };
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const vec3 a = whole(), along = whole(), from = random.point(10) + vec3(0, 0, 400);
        const double second = i % 3 == 2 ? 0 : 1, third = i % 3 == 0 ? 3 : second;
        const vec3 towards = a + random.number(0, third) * along;
        const Ray ray{from, towards - from};
        hits += intersect(ray, a, a + second * along, a + third * along).has_value() ? 1 : 0;
    }
    return hits;
}

// ---- rays that leave a triangle

// Triangles of a length up to 2 near the origin.
enum class Leaving { inPlaneX0, inPlaneY0, inPlaneY001, anywhere, slender100, slender1e4, slender1e6, slender1e8 };

inline std::array<vec3, 3> triangleToLeave(Random& random, Leaving kind) {
    std::array<vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    const auto slender = [&](double aspect) {
        const vec3 along = random.direction(), across = glm::normalize(glm::cross(along, random.direction()));
        corners[1] = corners[0] + along;
        corners[2] = corners[0] + random.number(0, 1) * along + across / aspect;
    };
    switch (kind) {
        case Leaving::inPlaneX0:
            for (vec3& corner : corners) corner.x = 0;
            break;
        case Leaving::inPlaneY0:
            for (vec3& corner : corners) corner.y = 0;
            break;
        case Leaving::inPlaneY001:
            for (vec3& corner : corners) corner.y = 0.01;
            break;
        case Leaving::anywhere:
            break;
        case Leaving::slender100:
            slender(100);
            break;
        case Leaving::slender1e4:
            slender(1e4);
            break;
        case Leaving::slender1e6:
            slender(1e6);
            break;
        case Leaving::slender1e8:
            slender(1e8);
            break;
    }
    return corners;
}

// How many of `count` rays that leave such a triangle, in any direction, meet it again. `start` is a function of a place, the
// normal, the direction and the largest sizes of the corners' coordinates.
template <typename Start, typename Intersect>
long metAgain(Leaving kind, long count, Start start, Intersect intersect) {
    Random random(27);
    long met = 0;
    for (long i = 0; i < count; ++i) {
        const auto [a, b, c] = triangleToLeave(random, kind);
        double v = random.number(0, 1), w = random.number(0, 1);
        if (v + w > 1) v = 1 - v, w = 1 - w;
        const vec3 place = (1 - v - w) * a + v * b + w * c, normal = glm::normalize(glm::cross(b - a, c - a));
        const vec3 size = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c))), way = random.direction();
        met += intersect(Ray{start(place, normal, way, size), way}, a, b, c).has_value() ? 1 : 0;
    }
    return met;
}

}  // namespace mv::test
