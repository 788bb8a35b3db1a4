// The claims of shadow-polygons, and a test for each; X60 in docs/stability.md are its extremes.
//
// - [as-rays-show] In every preset and for any number of polygons the computed shadows are what rays show, in the picture and at
//   points of the polygons; without shadows they are not.
// - [same-by-both] The sphere leaves out no pair that has a shadow: both methods find the same dark parts, bit for bit.
// - [fewer-pairs] All pairs are n (n - 1) projections. Of a hundred papers the sphere leaves less than a tenth of them, and for
//   ten times as many papers about ten times as many.
// - [larger-papers] The larger the papers, the more of them overlap on the sphere, and the less it saves.
// - [on-one-ray] Each corner of a dark part lies in the receiver's plane and within it, and the line from the light to it meets the
//   caster on the way.
// - [caps-hold] A cap holds all of its polygon's projection, and the distances of the nearest and the farthest point.
// - [between-only] What is behind the receiver's plane, in it, or beyond the light throws no shadow. Of a polygon that goes through
//   the plane only the part before it does.
// - [seen-part] A dark part is drawn where its receiver is seen, and nowhere else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/geometry/ray.h"
#include "mv/math/clip.h"
#include "mv/study/study.h"
#include "shadow-polygons/shadow-polygons.h"
#include "support/demo_run.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;
using namespace mv::shadow_polygons;

namespace {

Settings papers(int count, const vec3& light, double size = 1) {
    return {.polygons = count, .size = size, .light = light};
}

Shadows shadowsBy(Method method, const Settings& s) { return shadowsOf(method, polygonsOf(s), s.light); }

// A square of that half side about a middle, along two axes.
FlatPolygon square(const vec3& middle, double half, const vec3& u, const vec3& v) {
    return {{middle - half * (u + v), middle + half * (u - v), middle + half * (u + v), middle - half * (u - v)}};
}
const vec3 alongX(1, 0, 0), alongY(0, 1, 0), alongZ(0, 0, 1);

double shadowArea(const FlatPolygon& receiver, const FlatPolygon& caster, const vec3& light) {
    const auto made = receiverOf(receiver, light);
    return made ? polygonArea(shadowOn(*made, caster)) : 0;
}

const std::vector<vec3> lights{{0.6, 3.1, 0.5}, {-3, 6, 2}, {1, 1.5, -1}, {0, 0.2, 0}, {2.5, 2, -2.5}};

}  // namespace

TEST(ShadowPolygonsFull, as_rays_show) {
    DemoRun run("shadow-polygons", 320, 180);
    for (const Preset& preset : stage().info().presets) {
        run.preset(preset.name);
        run.picture();
        // A coarse grid of some 5000 pixels; one that an edge runs through is decided by the GPU's rounding.
        EXPECT_LT(run.readout("wrong"), 0.05) << preset.name;
        EXPECT_GT(run.readout("shadows"), 0) << preset.name;
        run.set("method", "none").picture();
        EXPECT_GT(run.readout("wrong"), 1) << preset.name;
    }
    Study study = *stage().info().study;
    const StudyRun result = runStudy(stage(), study, {.timed = false});
    ASSERT_EQ(result.rows.size(), 15U);
    for (const StudyRow& row : result.rows) {
        ASSERT_TRUE(row.ok()) << row.method << ": " << row.status;
        if (row.method == "no shadow")
            EXPECT_GT(row.all.fraction, 0.01);
        else
            EXPECT_EQ(row.all.fraction, 0) << row.method << " " << row.parameter;
    }
}

TEST(ShadowPolygons, same_by_both) {
    long found = 0;
    for (const vec3& light : lights) {
        for (const int count : {2, 7, 40, 120}) {
            for (const double size : {0.3, 1.0, 3.0}) {
                const Settings s = papers(count, light, size);
                const Shadows all = shadowsBy(Method::allPairs, s), few = shadowsBy(Method::sphere, s);
                EXPECT_LE(few.pairs.kept.size(), all.pairs.kept.size());
                ASSERT_EQ(few.dark.size(), all.dark.size()) << count << " " << size;
                for (std::size_t i = 0; i < few.dark.size(); ++i) {
                    ASSERT_EQ(few.dark[i].of, all.dark[i].of);
                    ASSERT_EQ(few.dark[i].corners, all.dark[i].corners);
                }
                found += long(few.dark.size());
            }
        }
    }
    EXPECT_GT(found, 1000);
}

TEST(ShadowPolygonsFull, fewer_pairs) {
    DemoRun run("shadow-polygons", 96, 54);
    const auto projections = [&](const std::string& method, int count) {
        run.set("method", method).set("polygons", count).picture();
        return run.readout("projections");
    };
    for (const int count : {2, 24, 100}) EXPECT_EQ(projections("all-pairs", count), count * (count - 1));
    EXPECT_EQ(run.readout("pairs-compared"), 0);
    EXPECT_EQ(run.readout("shadows"), shadowsBy(Method::allPairs, papers(100, Settings{}.light)).dark.size());
    EXPECT_LT(projections("sphere", 100), 0.1 * 100 * 99);
    EXPECT_LT(run.readout("pairs-compared"), 100 * 99 / 2);
    // Over several places of the light, since of ten papers it is a matter of chance which overlap
    double few = 0, many = 0;
    for (const vec3& light : lights) {
        few += double(shadowsBy(Method::sphere, papers(25, light)).pairs.kept.size());
        many += double(shadowsBy(Method::sphere, papers(250, light)).pairs.kept.size());
    }
    EXPECT_GT(many, 5 * few);
    EXPECT_LT(many, 20 * few);
}

TEST(ShadowPolygons, larger_papers) {
    std::size_t last = 0;
    for (const double size : {0.2, 0.5, 1.0, 2.0, 3.0}) {
        const std::size_t kept = shadowsBy(Method::sphere, papers(60, Settings{}.light, size)).pairs.kept.size();
        EXPECT_GT(kept, last) << size;
        last = kept;
    }
    EXPECT_GT(double(last), 0.2 * 60 * 59);
}

TEST(ShadowPolygons, on_one_ray) {
    int corners = 0;
    for (const vec3& light : lights) {
        const Settings s = papers(60, light);
        const std::vector<FlatPolygon> polygons = polygonsOf(s);
        for (const Shadow& shadow : shadowsBy(Method::sphere, s).dark) {
            const FlatPolygon &on = polygons[shadow.of.receiver], &by = polygons[shadow.of.caster];
            const vec3 up = glm::normalize(glm::cross(on.corners[1] - on.corners[0], on.corners[2] - on.corners[0]));
            const double towards = glm::dot(up, light - on.corners[0]) > 0 ? 1 : -1;
            vec3 middle(0);
            for (const vec3& corner : shadow.corners) {
                middle += corner / double(shadow.corners.size());
                // Some roundings of coordinates of 5; the light's height over the plane, 0.01 at least here, divides them.
                EXPECT_NEAR(glm::dot(up, corner - on.corners[0]), 0, 1e-12);
                for (std::size_t i = 0; i < on.corners.size(); ++i) {
                    const vec3 a = on.corners[i], b = on.corners[(i + 1) % on.corners.size()];
                    EXPECT_GT(glm::dot(up, glm::cross(b - a, corner - a)) / glm::distance(a, b), -1e-11);
                }
                ++corners;
            }
            // Counter-clockwise as the light sees it, and its middle behind the caster
            const vec3 turns = glm::cross(shadow.corners[1] - shadow.corners[0], shadow.corners[2] - shadow.corners[0]);
            EXPECT_GT(towards * glm::dot(turns, up), 0);
            bool meets = false;
            for (std::size_t k = 2; k < by.corners.size(); ++k) {
                const auto hit =
                    intersectTriangle(Ray{middle, light - middle}, by.corners[0], by.corners[k - 1], by.corners[k]);
                meets |= hit && hit->t < 1;
            }
            EXPECT_TRUE(meets);
        }
    }
    EXPECT_GT(corners, 500);
}

TEST(ShadowPolygons, caps_hold) {
    Random random(116);
    int small = 0;
    for (int i = 0; i < 3000; ++i) {
        const vec3 middle = random.point(3), u = random.direction(), light = random.point(2);
        const vec3 v = glm::normalize(glm::cross(u, random.direction()));
        const FlatPolygon polygon = square(middle, random.number(0.1, 1.5), u, v);
        const Cap cap = capOf(polygon, light);
        small += cap.chord < 2 ? 1 : 0;
        for (int k = 0; k < 30; ++k) {
            const double p = random.number(0, 1), q = random.number(0, 1);
            const vec3 at = polygon.corners[0] + p * (polygon.corners[1] - polygon.corners[0]) +
                            q * (polygon.corners[3] - polygon.corners[0]);
            const double distance = glm::distance(at, light);
            EXPECT_LE(glm::distance(cap.axis, (at - light) / distance), cap.chord + 1e-15);
            EXPECT_LE(cap.nearest, distance * (1 + 1e-15));
            EXPECT_GE(cap.farthest, distance * (1 - 1e-15));
        }
    }
    EXPECT_GT(small, 1500);
    EXPECT_LT(small, 3000);
    // One that holds the light has all of the sphere.
    EXPECT_EQ(capOf(square({0, 0, 0}, 1, alongX, alongZ), {0.2, 0, 0.1}).chord, 2);
}

TEST(ShadowPolygons, between_only) {
    const FlatPolygon floor = square({0, 0, 0}, 100, alongX, alongZ);
    const vec3 light(0, 4, 0);
    // At half of the height everything is twice as large.
    EXPECT_NEAR(shadowArea(floor, square({0, 2, 0}, 1, alongX, alongZ), light), 16, 1e-12);
    EXPECT_EQ(shadowArea(floor, square({0, -2, 0}, 1, alongX, alongZ), light), 0);
    EXPECT_EQ(shadowArea(floor, square({0, 5, 0}, 1, alongX, alongZ), light), 0);
    EXPECT_EQ(shadowArea(floor, square({0, 4, 3}, 1, alongX, alongZ), light), 0);
    EXPECT_EQ(shadowArea(floor, square({0, 0, 0}, 1, alongX, alongZ), light), 0);
    // From below, the same polygon throws one on the underside.
    EXPECT_NEAR(shadowArea(floor, square({0, -2, 0}, 1, alongX, alongZ), {0, -4, 0}), 16, 1e-12);
    // Upright through the floor, from y = -1 to 1 at x = 1 and two wide in z: of the half above, the shadow goes from x = 1, 2 wide, to
    // x = 4/3, 8/3 wide.
    const FlatPolygon upright = square({1, 0, 0}, 1, alongY, alongZ);
    EXPECT_NEAR(shadowArea(floor, upright, light), (2 + 8.0 / 3) / 2 / 3, 1e-12);
    // Up beyond the light: the shadow ends where the floor does, at x = 100, and begins at x = 3 * 4/2, where the lower edge's is.
    const FlatPolygon beyond = square({3, 4, 0}, 2, alongY, alongZ);
    const double begin = 3 * 4 / 2.0, widthThere = 4 * 4 / 2.0, end = 100, widthAtEnd = widthThere * end / begin;
    EXPECT_NEAR(shadowArea(floor, beyond, light), (widthThere + widthAtEnd) / 2 * (end - begin), 1e-9);
    // The light in the receiver's plane: neither side is lit, and nothing is divided by 0.
    EXPECT_FALSE(receiverOf(floor, {3, 0, 1}));
    EXPECT_FALSE(receiverOf(floor, {300, 0, 1}));
    EXPECT_THROW((void)receiverOf({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, light), Error);
}

TEST(ShadowPolygons, seen_part) {
    DemoRun run("shadow-polygons", 320, 180);
    run.set("show", "scene").set("polygons", 60);
    const Picture with = run.picture(), without = run.set("method", "none").picture();
    // A pixel that a shadow changes gets darker, in every channel.
    long darker = 0, lighter = 0;
    for (int y = 0; y < with.height; ++y) {
        for (int x = 0; x < with.width; ++x) {
            const Pixel a = with.at(x, y), b = without.at(x, y);
            if (a == b) continue;
            (a.red <= b.red && a.green <= b.green && a.blue <= b.blue ? darker : lighter) += 1;
        }
    }
    EXPECT_GT(darker, 1000);
    EXPECT_EQ(lighter, 0);
    // And it is that of the surface seen there: seen from below, nothing is, since what is seen of the floor faces away from the light.
    run.set("polygons", 2).set("spin-x", 180);
    const Picture below = run.set("method", "sphere").picture();
    EXPECT_EQ(run.set("method", "none").picture(), below);
}
