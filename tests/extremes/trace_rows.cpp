// X22: rays that leave a surface, at every scale. Y20: Schlick's curve by the angle within glass.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "extremes/row.h"
#include "ray-trace/whitted.h"
#include "shared/fresnel.h"
#include "support/random.h"
#include "support/ray_trials.h"
#include "support/textbook_rays.h"

using namespace mv;
using namespace mv::test;

namespace {

struct SelfHits {
    double naive = 0, ours = 0;
};

// A ball of that radius: rays that leave it outwards must meet nothing, those that go in meet its other side.
SelfHits fromBall(double size) {
    Random random(22);
    TracedScene scene;
    scene.balls = {{size * vec3(3, 1, -2), size, {}}};
    SelfHits hits;
    for (int i = 0; i < 100'000; ++i) {
        const vec3 eye = scene.balls[0].center + 9.0 * size * random.direction(),
                   aim = scene.balls[0].center + 0.9 * size * random.direction();
        const auto met = firstMet(scene, {eye, aim - eye});
        if (!met) continue;
        const vec3 way = random.direction();
        const double inwards = -glm::dot(way, met->normal), chord = std::max(0.0, 2 * size * inwards);
        const auto isWrong = [&](const vec3& start) {
            const auto next = firstMet(scene, {start, way});
            return inwards <= 0 ? next.has_value() : !next || !(next->t > 0.5 * chord);
        };
        hits.naive += isWrong(Ray{eye, aim - eye}.at(met->t));
        hits.ours += isWrong(startFrom(scene, *met, way));
    }
    return hits;
}

// A mesh: a ray must not meet the triangle that it leaves.
SelfHits fromMesh(double size) {
    Random random(23);
    std::vector<SceneTriangle> triangles = teapotTriangles(6);
    for (SceneTriangle& one : triangles) {
        for (vec3* corner : {&one.a, &one.b, &one.c}) *corner = size * (*corner + vec3(3, 1, -2));
    }
    TracedScene scene;
    scene.mesh = findTriangles(RayStructure::tree, std::move(triangles));
    SelfHits hits;
    for (int i = 0; i < 100'000; ++i) {
        const vec3 middle = size * vec3(3, 1.6, -2), eye = middle + 6.0 * size * random.direction();
        const vec3 aim = middle + 0.7 * size * random.direction();
        const auto met = firstMet(scene, {eye, aim - eye});
        if (!met) continue;
        const vec3 way = random.direction();
        const auto meetsItself = [&](const vec3& start) {
            const auto next = firstMet(scene, {start, way});
            return next && next->triangle == met->triangle;
        };
        hits.naive += meetsItself(Ray{eye, aim - eye}.at(met->t));
        hits.ours += meetsItself(startFrom(scene, *met, way));
    }
    return hits;
}

Row leaving(const std::string& scale, SelfHits hits, const std::string& what) {
    return {.id = "X22 " + scale + (what == "ball" ? "" : " mesh"),
            .input = "100 000 rays that leave a " + what + " of the size " + scale + ", in any direction",
            .measured = "rays that meet the surface that they leave where they leave it",
            .naive = "start at origin + t direction",
            .naiveError = hits.naive,
            .ours = "startFrom",
            .ourError = hits.ours,
            .tolerance = 0,
            .reason = "the start is off the surface by more than its own roundings and those of the next test"};
}

[[maybe_unused]] const bool x22a = addRow([] { return leaving("1e-3", fromBall(1e-3), "ball"); });
[[maybe_unused]] const bool x22b = addRow([] { return leaving("1", fromBall(1), "ball"); });
[[maybe_unused]] const bool x22c = addRow([] { return leaving("1e3", fromBall(1e3), "ball"); });
[[maybe_unused]] const bool x22d = addRow([] { return leaving("1e6", fromBall(1e6), "ball"); });
[[maybe_unused]] const bool x22e = addRow([] { return leaving("1e-3", fromMesh(1e-3), "teapot of triangles"); });
[[maybe_unused]] const bool x22f = addRow([] { return leaving("1e6", fromMesh(1e6), "teapot of triangles"); });

// One triangle: off by the roundings of the coordinates along its normal, then the watertight test as published; and ours.
Row leavingTriangle(const std::string& id, const std::string& which, Leaving kind) {
    const auto byComponent = [](const vec3& place, const vec3& normal, const vec3& way, const vec3& size) {
        const double off = 8 * std::numeric_limits<double>::epsilon() * glm::dot(glm::abs(normal), size);
        return glm::dot(normal, way) < 0 ? place - off * normal : place + off * normal;
    };
    const auto beside = [](const vec3& place, const vec3& normal, const vec3& way, const vec3& size) {
        return besideSurface(place, normal, way, size, 8);
    };
    return {.id = "X22 " + id,
            .input = "100 000 rays that leave triangles " + which + ", in any direction",
            .measured = "rays that meet the triangle that they leave",
            .naive = "off by 8 roundings of each coordinate along the normal, and Woop's test with t by its weights",
            .naiveError = double(metAgain(kind, 100'000, byComponent, publishedWatertight)),
            .ours = "besideSurface, intersectTriangle",
            .ourError = double(metAgain(kind, 100'000, beside, intersectTriangle<double>)),
            .tolerance = 0,
            .reason =
                "the start is off by 8 roundings of the largest coordinate, which the next test mixes with the others, "
                "and t has the sign of the distance from the plane, or there is no hit"};
}

[[maybe_unused]] const bool x22g =
    addRow([] { return leavingTriangle("in y = 0", "in the plane y = 0", Leaving::inPlaneY0); });
[[maybe_unused]] const bool x22h =
    addRow([] { return leavingTriangle("slender 1e2", "100 times as long as wide", Leaving::slender100); });
[[maybe_unused]] const bool x22i =
    addRow([] { return leavingTriangle("slender 1e6", "1e6 times as long as wide", Leaving::slender1e6); });

// The largest difference from Fresnel's equations, where glass of index 1.5 is left and there is light outside.
double schlickOff(bool byAngleOutside) {
    double most = 0;
    for (int i = 0; i <= 100'000; ++i) {
        const double cosine = i / 100'000.0, square = 1 - 2.25 * (1 - cosine * cosine);
        if (square <= 0) continue;
        const double curve = schlick(byAngleOutside ? std::sqrt(square) : cosine, 0.04);
        most = std::max(most, std::abs(fresnel(cosine, 1 / 1.5).reflected - curve));
    }
    return most;
}

[[maybe_unused]] const bool y20 = addRow([] {
    return Row{.id = "Y20",
               .input = "a ray that leaves glass of index 1.5, up to total reflection",
               .measured = "error of the part that is reflected",
               .naive = "Schlick's curve by the angle within",
               .naiveError = schlickOff(false),
               .ours = "Schlick's curve by the angle outside",
               .ourError = schlickOff(true),
               .tolerance = 0.1,
               .reason =
                   "both curves end at 0.04 and at 1; a fifth power is within a tenth of Fresnel's equations "
                   "between them"};
});

}  // namespace
