#include "shared/relief.h"
#include "shared/relief_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "../math/support.h"
#include "mv/geometry/check.h"
#include "mv/geometry/mesh_tangents.h"
#include "mv/geometry/ray_caster.h"
#include "mv/geometry/shapes.h"
#include "shared/relief_rays.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

// Points of the smooth surface, of all of it.
vec3 anyPoint(ReliefBody body, Random& random) {
    if (body == ReliefBody::wall) return {random.number(-4, 4), random.number(-1, 1), 0};
    vec3 p(0);
    while (glm::length(p) < 0.1) p = {random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)};
    return glm::normalize(p);
}

constexpr ReliefBody bodies[] = {ReliefBody::wall, ReliefBody::orange};

}  // namespace

TEST(Relief, slope_is_how_height_changes) {
    Random random(20);
    for (const Relief& relief :
         {Relief{ReliefBody::wall}, Relief{ReliefBody::wall, 0.08, true}, Relief{ReliefBody::orange}}) {
        double steep = 0, low = 1, high = 0;
        for (int i = 0; i < 20'000; ++i) {
            const vec3 p = anyPoint(relief.body, random);
            const ReliefPoint at = reliefAt(relief, p);
            EXPECT_EQ(at.height, reliefHeight(relief, p));
            EXPECT_LT(glm::distance(at.smooth, p), 1e-15);
            EXPECT_NEAR(glm::dot(at.slope, at.out), 0, 1e-12);
            // Differences of 2e-5: their own error is the third derivative, some 1e5, times the square of it.
            for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}) {
                const vec3 way = 1e-5 * (axis - glm::dot(axis, at.out) * at.out);
                const double change = reliefHeight(relief, p + way) - reliefHeight(relief, p - way);
                EXPECT_NEAR(change, 2 * glm::dot(at.slope, way), 1e-8);
            }
            steep = std::max(steep, glm::length(at.slope));
            low = std::min(low, at.height);
            high = std::max(high, at.height);
        }
        EXPECT_LT(steep, steepest(relief.body));
        EXPECT_GT(steep, 0.5 * steepest(relief.body)) << "a bound that is far too careful makes rays slow";
        EXPECT_GE(low, 0);
        EXPECT_LT(low, 0.2);
        EXPECT_LE(high, 1);
        EXPECT_GT(high, 0.95);
    }
}

TEST(Relief, wall_repeats_and_is_mirrored) {
    Random random(21);
    for (int i = 0; i < 1000; ++i) {
        const vec3 p = anyPoint(ReliefBody::wall, random);
        const ReliefPoint at = reliefAt({}, p), next = reliefAt({}, p + vec3(2, 0, 0));
        EXPECT_NEAR(next.height, at.height, 1e-12);  // roundings of p + 2, by a slope of 29
        const Relief mirrored{ReliefBody::wall, 0.1, true};
        const vec3 other(-p.x, p.y, 0);
        EXPECT_EQ(reliefAt(mirrored, p).height, reliefAt(mirrored, other).height);
        EXPECT_EQ(reliefAt(mirrored, p).slope.x, -reliefAt(mirrored, other).slope.x);
    }
}

// The normal of a displaced surface is across it.
TEST(Relief, displaced_normals_are_across_the_displaced_surface) {
    Random random(22);
    for (const ReliefBody body : bodies) {
        const Relief relief{body, 0.2};
        for (int i = 0; i < 2000; ++i) {
            const vec3 p = anyPoint(body, random);
            const ReliefPoint at = reliefAt(relief, p);
            const vec3 normal = displacedNormal(relief, at);
            EXPECT_NEAR(glm::length(normal), 1, 1e-12);
            for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}) {
                const vec3 way = 1e-5 * (axis - glm::dot(axis, at.out) * at.out);
                const vec3 edge = displacedPoint(relief, reliefAt(relief, p + way)) -
                                  displacedPoint(relief, reliefAt(relief, p - way));
                EXPECT_NEAR(glm::dot(edge, normal), 0, 1e-8);  // as above
            }
        }
    }
}

// Two ways to the same truth that share the relief's height alone: a march, and a mesh that is hit by rays.
TEST(Relief, lines_of_sight_hit_the_displaced_mesh) {
    for (const ReliefBody body : bodies) {
        const Relief relief{body, 0.1};
        const MeshData mesh =
            displaced(relief, body == ReliefBody::wall ? wallPiece(relief, -5, 2, 350, 100) : sphere(1, 512, 256));
        Scene scene;
        scene.objects = {{.name = "relief", .mesh = mesh}};
        const RayCaster caster(scene);
        Random random(23);
        int hits = 0, apart = 0;
        for (int i = 0; i < 1000; ++i) {
            const double a = radians(body == ReliefBody::wall ? random.number(0, 75) : random.number(0, 360));
            const vec3 way(-std::sin(a), 0, -std::cos(a));
            const vec3 at(random.number(-1, 1), random.number(-0.9, 0.9), 0);
            const vec3 from =
                (body == ReliefBody::wall ? at : at.x * vec3(way.z, 0, -way.x) + at.y * vec3(0, 1, 0)) - 3.0 * way;
            const auto hit = firstHit(relief, from, way);
            const auto met = caster.nearest({from, way});
            if (hit.has_value() != met.has_value()) {
                ++apart;
                continue;
            }
            if (!hit) continue;
            ++hits;
            // A triangle of 0.02 lies beside the surface by an eighth of its square times the curvature: of bricks' edges
            // 0.1 * 5.8/0.07^2, so 0.006; along the line of sight that is up to four times as much.
            if (glm::distance(displacedPoint(relief, *hit), from + met->t * way) > 0.024) ++apart;
        }
        EXPECT_GT(hits, 500);
        EXPECT_LE(apart, hits / 50) << "at edges";
    }
}

TEST(Relief, rays_refuse_what_never_arrives) {
    EXPECT_EQ(refusal([] { (void)firstHit({}, vec3(0, 0, 1), vec3(1, 0, 0)); }),
              "firstHit: the line must run towards the wall, 0");
    EXPECT_FALSE(firstHit({ReliefBody::orange}, vec3(1.001, 0, 5), vec3(0, 0, -1)));
    // Straight down on a wall without depth
    const auto hit = firstHit({ReliefBody::wall, 0}, vec3(0.3, 0.2, 5), vec3(0, 0, -1));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->smooth, vec3(0.3, 0.2, 0));
}

TEST(Relief, maps_have_what_is_in_the_middle_of_their_texels) {
    for (const ReliefBody body : bodies) {
        const FloatPicture painted = paintedMap(body, 32);
        EXPECT_EQ(painted.width, body == ReliefBody::wall ? 32 : 64);
        const Relief relief{body, 0.1};
        const MeshData mesh = body == ReliefBody::wall ? wallPiece(relief, 0, 2, 32, 32) : sphere(1, 64, 32);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            // The meshes' texture coordinates are those of the maps
            if (body == ReliefBody::orange && std::abs(mesh.positions[i].y) > 0.999F) continue;
            EXPECT_LT(glm::distance(vec3(mesh.positions[i]), smoothPoint(body, vec2(mesh.texCoords[i]))), 1e-6);
        }
        const ReliefPoint at = reliefAt(relief, smoothPoint(body, {5.5 / painted.width, 9.5 / 32}));
        const float* const texel = &painted.values[4 * pixelIndex(5, 9, painted.width)];
        EXPECT_NEAR(double(texel[3]), at.height, 1e-7);
        EXPECT_NEAR(double(texel[0]), at.color.x, 1e-7);
    }
}

TEST(Relief, maps_normals_are_of_second_order) {
    // A quarter, once a brick's edge, 0.07 units, is many texels wide: 18 of the finest map, and 4 of the coarsest.
    const Relief wall{ReliefBody::wall, 0.04}, orange{ReliefBody::orange, 0.04};
    const double coarse = normalMapError(wall, 128, false), middle = normalMapError(wall, 256, false),
                 fine = normalMapError(wall, 512, false);
    EXPECT_GT(coarse / middle, 2);
    EXPECT_NEAR(middle / fine, 4, 0.6);
    // A pore of 0.1 units is 8 rows of texels wide of 256, and 4 of 128.
    EXPECT_NEAR(normalMapError(orange, 128, false) / normalMapError(orange, 256, false), 4, 1);
    // In bytes no map gets better than its steps: 1/255 of the depth over two texels, or 1/255 of a normal.
    EXPECT_GT(normalMapError(wall, 512, true), 2 * fine);
}

TEST(Relief, parallax_shifts_towards_the_eye_and_never_without_end) {
    EXPECT_EQ(parallaxShift(vec3(0, 0, 1), 0.1, 0), vec2(0));
    EXPECT_EQ(parallaxShift(glm::normalize(vec3(1, 1, 1)), 0.1, 1), vec2(0));
    const vec2 shift = parallaxShift(glm::normalize(vec3(1, 0, 1)), 0.1, 0.25);
    EXPECT_NEAR(shift.x, -0.075, 1e-15);  // 45 degrees: as far as it is deep
    EXPECT_EQ(shift.y, 0);
    for (const double z : {0.05, 1e-3, 0.0, -0.1}) {
        const vec2 most = parallaxShift(glm::normalize(vec3(1, 0, z)), 0.1, 0);
        EXPECT_GE(most.x, -0.1 / flattestSight);
    }
}

TEST(Relief, light_behind_lights_nothing) {
    const vec3 n(0, 0, 1), color(0.5, 0.25, 0.125);
    EXPECT_EQ(reliefLight(color, n, vec3(0, 0, -1), n), 0.2 * color);
    EXPECT_EQ(reliefLight(color, n, vec3(1, 0, 0), vec3(-1, 0, 0)), 0.2 * color);
    EXPECT_LT(glm::distance(reliefLight(color, n, n, n), color + 0.15), 1e-15);
}
