// X18 to X21: rays against spheres far away and under the eye, against the edges of a mesh, and against triangles that are
// small, thin, or nothing. Y24: points beside an edge.
#include <algorithm>
#include <array>
#include <span>

#include "accuracy/function.h"
#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/ray_forms.h"
#include "support/ray_trials.h"
#include "support/textbook_rays.h"

using namespace mv;
using namespace mv::test;

namespace {

double ulpsOf(const SphereErrors& errors) {
    return errors.falseHits + errors.misses > 0 ? infinite : errors.largestUlps;
}

Row sphereAt(const std::string& id, float distance) {
    const auto trials = sphereTrials<Wide>(distance, 20000);
    return {.id = id,
            .input = "20 000 rays in float from " + id.substr(4) +
                     " away, half of them into half the radius of a unit sphere, half beside it",
            .measured = "error of t (ulp); inf: false hits, or misses",
            .naive = "the quadratic formula",
            .naiveError = ulpsOf(sphereErrors(trials, textbookSphere<float>)),
            .ours = "intersectSphere",
            .ourError = ulpsOf(sphereErrors(trials, intersectSphere<float>)),
            .tolerance = 2,
            .reason =
                "t is rounded once, half an ulp; the root has the roundings of the coordinates' products, two of them "
                "times 0.58 for what is half a radius off the middle, together 1.7"};
}
[[maybe_unused]] const bool x18a = addRow([] { return sphereAt("X18 1e1", 1e1F); });
[[maybe_unused]] const bool x18b = addRow([] { return sphereAt("X18 1e2", 1e2F); });
[[maybe_unused]] const bool x18c = addRow([] { return sphereAt("X18 1e3", 1e3F); });
[[maybe_unused]] const bool x18d = addRow([] { return sphereAt("X18 1e4", 1e4F); });
[[maybe_unused]] const bool x18e = addRow([] { return sphereAt("X18 1e5", 1e5F); });
[[maybe_unused]] const bool x18f = addRow([] { return sphereAt("X18 1e6", 1e6F); });

// Rays that pass the outline of a sphere, from all these distances: the error of both ends, where a miss is a line nearest
// to the centre, in ulp of what a rounding of the coordinates would change.
template <typename Intersect>
double grazingUlps(Intersect intersect) {
    const auto& all = accuracy::attackedFunctions();
    const auto sphere = std::find_if(all.begin(), all.end(), [](const auto& f) { return f.name == "intersectSphere"; });
    const accuracy::Form form =
        accuracy::withMissesOfSphere(accuracy::makeForm<float>("", [&](const accuracy::ArgumentsOf<float>& a) {
            const RayOf<float> ray{accuracy::vectorAt(a, 0), accuracy::vectorAt(a, 3)};
            const auto met = intersect(ray, accuracy::vectorAt(a, 6), a[9]);
            constexpr float none = std::numeric_limits<float>::infinity();
            return met ? std::array<float, 2>{met->near, met->far} : std::array<float, 2>{none, none};
        }));
    Random random(28);
    double worst = 0;
    for (int i = 0; i < 6000; ++i) {
        const vec3 towards = random.direction(), across = glm::normalize(glm::cross(towards, random.direction()));
        const vec3 origin = -std::pow(10.0, 1 + i % 6) * towards;
        accuracy::Arguments a{};
        accuracy::put(a, 0, origin);
        accuracy::put(a, 3, glm::normalize(random.number(0.5, 1.5) * across - origin));
        a[9] = 1;
        worst = worse(worst, accuracy::errorOfCall(*sphere, form, a).ulp);
    }
    return worst;
}
[[maybe_unused]] const bool x18grazing = addRow([] {
    return Row{.id = "X18 outline",
               .input = "6000 rays in float from 1e1 to 1e6 away, 0.5 to 1.5 radii beside the middle of a unit sphere",
               .measured =
                   "error of both ends (ulp of what a rounding of the coordinates changes); a miss is where the line "
                   "is nearest to the centre",
               .naive = "the quadratic formula",
               .naiveError = grazingUlps(textbookSphere<float>),
               .ours = "intersectSphere",
               .ourError = grazingUlps(intersectSphere<float>),
               .tolerance = 8,
               .reason =
                   "the function's bound, for which `test-adversary` looks everywhere: a rounding of each term of the "
                   "discriminant and of the middle"};
});

Row groundUnderEye(const std::string& id, double radius) {
    return {.id = id,
            .input = "1000 rays from an eye 1 above a ball of radius " + id.substr(4),
            .measured = "relative error of t",
            .naive = "the quadratic formula in float",
            .naiveError = groundError<Wide, float>(radius, textbookSphere<float>),
            .ours = "intersectSphere in double",
            .ourError = groundError<Wide, double>(radius, intersectSphere<double>),
            .tolerance = 2e-15,
            .reason = "c = 2r + 1 is exact here, q a sum of numbers of one sign: some roundings"};
}
[[maybe_unused]] const bool x19a = addRow([] { return groundUnderEye("X19 1e2", 1e2); });
[[maybe_unused]] const bool x19b = addRow([] { return groundUnderEye("X19 1e4", 1e4); });
[[maybe_unused]] const bool x19c = addRow([] { return groundUnderEye("X19 1e6", 1e6); });
[[maybe_unused]] const bool x19d = addRow([] {
    return Row{.id = "X19 double",
               .input = "1000 rays from an eye 1 above a ball of radius 1e6",
               .measured = "relative error of t",
               .naive = "the quadratic formula, even in double",
               .naiveError = groundError<Wide, double>(1e6, textbookSphere<double>),
               .ours = "intersectSphere in double",
               .ourError = groundError<Wide, double>(1e6, intersectSphere<double>),
               .tolerance = 2e-15,
               .reason = "as above: no difference of near numbers"};
});

Row meshFromWithin(const std::string& id, Aim aim) {
    const auto textbook = [](const auto& ray, const fvec3& a, const fvec3& b, const fvec3& c) {
        return textbookTriangle(ray, a, b, c, 0.0F);
    };
    return {.id = id,
            .input = "100 000 rays in float from within a closed mesh of 256 triangles, towards its " + id.substr(4),
            .measured = "rays that meet no triangle",
            .naive = "Möller and Trumbore's, without epsilon",
            .naiveError = static_cast<double>(missedRays<float>(aim, 100000, textbook)),
            .ours = "intersectTriangle",
            .ourError = static_cast<double>(missedRays<float>(aim, 100000, intersectTriangle<float>)),
            .tolerance = 0,
            .reason = "there is no way out of a closed mesh"};
}
[[maybe_unused]] const bool x20a = addRow([] { return meshFromWithin("X20 corners", Aim::corner); });
[[maybe_unused]] const bool x20b = addRow([] { return meshFromWithin("X20 edges", Aim::edge); });

// On which side of the edge from p to q the ray passes: the sign of a volume, exact.
int sideOf(const Ray& ray, const vec3& p, const vec3& q) {
    const Wide3 from = wide(ray.origin);
    const Wide volume = dot(wide(ray.direction), cross(wide(p) - from, wide(q) - from));
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

// A triangle about a random point within 1 of the origin, `length` long and `width` wide, in any direction.
std::array<vec3, 3> triangleOf(Random& random, double length, double width) {
    const vec3 at = random.point(1), along = random.direction();
    const vec3 across = glm::normalize(glm::cross(along, random.direction()));
    return {at, at + length * along, at + length * random.number(0, 1) * along + width * across};
}

template <typename Intersect>
double wrongAnswers(double length, double width, Intersect intersect) {
    Random random(21);
    double wrong = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto [a, b, c] = triangleOf(random, length, width);
        const double v = random.number(-0.5, 1), w = random.number(-0.5, 1);
        const vec3 towards = (1 - v - w) * a + v * b + w * c, from = 4.0 * random.direction();
        const Ray ray{from, towards - from};
        const int u = sideOf(ray, b, c) + sideOf(ray, c, a) + sideOf(ray, a, b);
        const auto found = intersect(ray, a, b, c);
        const bool right = found.has_value() == (std::abs(u) == 3);
        wrong += right && (!found || std::abs(found->t - 1) < 1e-6) ? 0 : 1;
    }
    return wrong;
}
const auto mollerTrumbore = [](const Ray& ray, const vec3& a, const vec3& b, const vec3& c) {
    return textbookTriangle(ray, a, b, c);
};
const auto woop = [](const Ray& ray, const vec3& a, const vec3& b, const vec3& c) {
    return intersectTriangle(ray, a, b, c);
};

Row smallTriangles(const std::string& id, const std::string& what, double length, double width) {
    return {.id = id,
            .input = "2000 triangles " + what + ", rays to points in and beside them, in double",
            .measured = "wrong answers",
            .naive = "Möller and Trumbore's, with the usual epsilon of 1e-6",
            .naiveError = wrongAnswers(length, width, mollerTrumbore),
            .ours = "intersectTriangle",
            .ourError = wrongAnswers(length, width, woop),
            .tolerance = 0,
            .reason = "rounding decides within 1e-9 of the size from a side, and none of these rays goes there"};
}
[[maybe_unused]] const bool x21b = addRow([] { return smallTriangles("X21 1e-4", "1e-4 large", 1e-4, 1e-4); });
[[maybe_unused]] const bool x21c = addRow([] { return smallTriangles("X21 1e-6", "1e-6 large", 1e-6, 1e-6); });
[[maybe_unused]] const bool x21d =
    addRow([] { return smallTriangles("X21 slivers", "1 long and 1e-6 wide", 1, 1e-6); });

[[maybe_unused]] const bool x21e = addRow([] {
    return Row{
        .id = "X21 no area",
        .input = "3000 triangles whose corners are on a line, two or three of them the same, rays to points of them",
        .measured = "hits of what has no area",
        .naive = "Möller and Trumbore's in double, without epsilon",
        .naiveError = double(hitsOfNothing([](const Ray& ray, const vec3& a, const vec3& b, const vec3& c) {
            return textbookTriangle(ray, a, b, c, 0.0);
        })),
        .ours = "intersectTriangle",
        .ourError = double(hitsOfNothing(woop)),
        .tolerance = 0,
        .reason = "whole numbers: that their area is 0 is exact"};
});

// Points as near to a triangle's slanting edge as doubles let them be, each on the side that is decided in Wide.
template <typename Holds>
double wronglyHeld(Holds holds) {
    Random random(24);
    double wrong = 0;
    for (int i = 0; i < 20'000; ++i) {
        const vec2 a(random.number(0, 1), random.number(0, 1)), b(random.number(17, 18), random.number(17, 18));
        const double along = random.number(0.01, 0.99);
        const vec2 at = a + along * (b - a);
        const Wide turn =
            (Wide(b.x) - Wide(a.x)) * (Wide(at.y) - Wide(a.y)) - (Wide(b.y) - Wide(a.y)) * (Wide(at.x) - Wide(a.x));
        const std::array<vec2, 3> corners{a, b, vec2(20, 0)};
        wrong += holds(std::span<const vec2>(corners), at) == (turn <= 0) ? 0 : 1;
    }
    return wrong;
}

[[maybe_unused]] const bool y24 = addRow([] {
    const auto byDifferences = [](std::span<const vec2> corners, const vec2& at) {
        const vec2 edge = corners[1] - corners[0], way = at - corners[0];
        return edge.x * way.y - edge.y * way.x <= 0;
    };
    return Row{
        .id = "Y24",
        .input = "20 000 points within a rounding of a triangle's edge",
        .measured = "points that are inside and said to be outside, or the other way round",
        .naive = "on which side of the edge: a difference of products of differences",
        .naiveError = wronglyHeld(byDifferences),
        .ours = "isInside",
        .ourError = wronglyHeld([](std::span<const vec2> corners, const vec2& at) { return isInside(corners, at); }),
        .tolerance = 0,
        .reason = "the sign is that of the exact sum"};
});

}  // namespace
