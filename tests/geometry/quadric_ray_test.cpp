#include "mv/geometry/quadric_ray.h"

#include "math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

// How far a point is from being on a body's surface, and whether it is inside; of sizes near 1.
double offCylinder(const vec3& p, double radius, double low, double high) {
    const double out = std::hypot(p.x, p.z) - radius;
    return std::max({out, low - p.y, p.y - high});
}
double offCone(const vec3& p, double radius, double height) {
    return std::max({std::hypot(p.x, p.z) - radius / height * (height - p.y), -p.y, p.y - height});
}
double offTorus(const vec3& p, double major, double minor) {
    return std::hypot(std::hypot(p.x, p.z) - major, p.y) - minor;
}

Ray towards(Random& random, double away) {
    const vec3 from = away * random.direction(), to = random.point(1.5);
    return {from, random.logarithmic(0.1, 10) * (to - from)};
}

// Ends lie on the surface; along the ray the sign is that of the interval, at points that are not within a hair of an end.
template <typename Off>
void expectInterval(const Ray& ray, const std::optional<RayInterval<double>>& met, const Off& off, double most) {
    const double unit = 1 / glm::length(ray.direction);
    if (met) {
        EXPECT_LE(met->near, met->far);
        EXPECT_GE(met->far, 0);
        EXPECT_NEAR(off(ray.at(met->near)), 0, most);
        EXPECT_NEAR(off(ray.at(met->far)), 0, most);
    }
    for (int i = 0; i <= 60; ++i) {
        const double t = (glm::length(ray.origin) - 3 + i / 10.0) * unit, is = off(ray.at(t));
        if (t < 0 || std::abs(is) < 1e-6) continue;
        EXPECT_EQ(is < 0, met && t >= met->near && t <= met->far) << t;
    }
}

}  // namespace

TEST(QuadricRay, intervals_are_the_inside) {
    Random random(1);
    int cylinders = 0, cones = 0;
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = towards(random, i % 4 == 0 ? 0.4 : 10);
        const auto cylinder = intersectCylinder(ray, 1.0, -0.5, 1.25);
        expectInterval(
            ray, cylinder, [](const vec3& p) { return offCylinder(p, 1, -0.5, 1.25); }, 1e-13);
        const auto cone = intersectCone(ray, 1.5, 2.0);
        expectInterval(
            ray, cone, [](const vec3& p) { return offCone(p, 1.5, 2); }, 1e-12);
        cylinders += cylinder ? 1 : 0;
        cones += cone ? 1 : 0;
    }
    EXPECT_GT(cylinders, 1000);
    EXPECT_GT(cones, 1000);
}

TEST(QuadricRay, the_first_of_up_to_four_places_on_a_torus) {
    Random random(2);
    int met = 0;
    for (int i = 0; i < 3000; ++i) {
        const double minor = random.number(0.05, 1);
        const Ray ray = towards(random, i % 4 == 0 ? 0.9 : 10);
        const auto t = intersectTorus(ray, 1.0, minor);
        const double unit = 1 / glm::length(ray.direction);
        if (t) {
            ++met;
            EXPECT_NEAR(offTorus(ray.at(*t), 1, minor), 0, 1e-12 / minor);
        }
        // Nothing of the surface before it: the sign stays
        const double end = t ? *t : (glm::length(ray.origin) + 3) * unit;
        const bool isInside = offTorus(ray.origin, 1, minor) < 0;
        for (int k = 1; k < 300; ++k) {
            const double is = offTorus(ray.at(end * k / 300), 1, minor);
            if (std::abs(is) > 1e-6) {
                EXPECT_EQ(is < 0, isInside) << i << " " << k;
            }
        }
    }
    EXPECT_GT(met, 1000);
}

TEST(QuadricRay, four_places_are_told_apart) {
    // Through the hole, over the ring: from +x towards -x in the middle plane
    const Ray ray{{5, 0, 0}, {-1, 0, 0}};
    EXPECT_NEAR(*intersectTorus(ray, 2.0, 0.5), 2.5, 1e-15);
    EXPECT_NEAR(*intersectTorus(Ray{{2, 0, 0}, {-1, 0, 0}}, 2.0, 0.5), 0.5, 1e-15);  // from inside the tube
    EXPECT_NEAR(*intersectTorus(Ray{{0, 0, 0}, {-1, 0, 0}}, 2.0, 0.5), 1.5, 1e-15);  // from the hole
    EXPECT_FALSE(intersectTorus(Ray{{0, 5, 0}, {0, -1, 0}}, 2.0, 0.5));              // along the axis
    EXPECT_NEAR(*intersectTorus(Ray{{2, 5, 0}, {0, -1, 0}}, 2.0, 0.5), 4.5, 1e-15);
    EXPECT_FALSE(intersectTorus(Ray{{5, 0, 0}, {1, 0, 0}}, 2.0, 0.5));             // behind
    EXPECT_NEAR(*intersectTorus(Ray{{5, 0, 0}, {-1, 0, 0}}, 1.0, 1.0), 3, 1e-15);  // without a hole
    EXPECT_FALSE(intersectTorus(ray, 0.5, 1.0));
}

TEST(QuadricRay, along_the_axis_the_side_and_through_the_tip) {
    const Ray down{{0.5, 9, 0}, {0, -2, 0}};
    const auto cylinder = intersectCylinder(down, 1.0, 0.0, 3.0);
    ASSERT_TRUE(cylinder);
    EXPECT_EQ(cylinder->near, 3);
    EXPECT_EQ(cylinder->far, 4.5);
    EXPECT_FALSE(intersectCylinder(Ray{{1.5, 9, 0}, {0, -2, 0}}, 1.0, 0.0, 3.0));
    const auto cone = intersectCone(down, 1.0, 2.0);
    ASSERT_TRUE(cone);
    EXPECT_EQ(cone->near, 4);  // at y = 1
    EXPECT_EQ(cone->far, 4.5);
    // Parallel to the side of a cone with slope 1: the equation is linear
    const auto steep = intersectCone(Ray{{0, -1, 0}, {-1, 1, 0}}, 2.0, 2.0);
    ASSERT_TRUE(steep);
    EXPECT_EQ(steep->near, 1);
    EXPECT_EQ(steep->far, 1.5);
    // In a plane through the axis, level with the middle
    const auto level = intersectCone(Ray{{9, 1, 0}, {-1, 0, 0}}, 2.0, 2.0);
    ASSERT_TRUE(level);
    EXPECT_EQ(level->near, 8);
    EXPECT_EQ(level->far, 10);
    // The half above the tip is no part of it
    EXPECT_FALSE(intersectCone(Ray{{9, 3, 0}, {-1, 0, 0}}, 2.0, 2.0));
    EXPECT_FALSE(intersectCone(Ray{{9, -1, 0}, {-1, 0, 0}}, 2.0, 2.0));
}

TEST(QuadricRay, disks) {
    const vec3 center(1, 2, 3), normal(0, 0, 5);
    EXPECT_EQ(*intersectDisk(Ray{{1, 2, 7}, {0, 0, -2}}, center, normal, 1.0), 2);
    EXPECT_EQ(*intersectDisk(Ray{{2, 2, -1}, {0, 0, 2}}, center, normal, 1.0), 2);
    EXPECT_FALSE(intersectDisk(Ray{{2.001, 2, 7}, {0, 0, -2}}, center, normal, 1.0));
    EXPECT_FALSE(intersectDisk(Ray{{1, 2, 7}, {0, 0, 2}}, center, normal, 1.0));
    EXPECT_FALSE(intersectDisk(Ray{{0, 2, 3}, {1, 0, 0}}, center, normal, 1.0));  // within it
    EXPECT_FALSE(intersectDisk(Ray{{1, 2, 7}, {0, 0, -2}}, center, vec3(0), 1.0));
}

// In float, far away: the textbook's b*b - 4ac has no digit left there.
TEST(QuadricRayExtremes, far_away_in_float) {
    Random random(3);
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 to = random.point(1.2), way = random.direction();
        const RayOf<float> ray{fvec3(to - 1e4 * way), fvec3(way)};
        const Ray exact{vec3(ray.origin), vec3(ray.direction)};
        const auto verdict = [&](bool inFloat, bool inDouble, double near) {
            if (near > 1e-2)
                wrong += inFloat == inDouble ? 0 : 1;  // not within the coordinates' roundings, 1e-3, of the outline
        };
        const double side = std::abs(exact.origin.x * exact.direction.z - exact.origin.z * exact.direction.x) /
                            std::hypot(exact.direction.x, exact.direction.z);
        verdict(intersectCylinder(ray, 1.0F, -1e5F, 1e5F).has_value(),
                intersectCylinder(exact, 1.0, -1e5, 1e5).has_value(), std::abs(side - 1));
        const auto cone = intersectCone(ray, 1.0F, 2.0F);
        const auto right = intersectCone(exact, 1.0, 2.0);
        if (right && cone && right->far - right->near > 0.1) {
            EXPECT_NEAR(double(cone->near), right->near, 1e-2);
        }
        if (right && right->far - right->near > 0.1) wrong += cone ? 0 : 1;
        const auto torus = intersectTorus(ray, 1.0F, 0.25F);
        const auto exactTorus = intersectTorus(exact, 1.0, 0.25);
        wrong += torus.has_value() == exactTorus.has_value() ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0);
}

TEST(QuadricRayExtremes, what_is_no_ray_and_no_body_meets_nothing) {
    for (const Ray& ray :
         {Ray{{0, 0, 5}, {0, 0, 0}}, Ray{{0, notANumber, 5}, {0, 0, -1}}, Ray{{0, 0, 5}, {infinite, 0, 0}}}) {
        EXPECT_FALSE(intersectCylinder(ray, 1.0, -1.0, 1.0));
        EXPECT_FALSE(intersectCone(ray, 1.0, 1.0));
        EXPECT_FALSE(intersectDisk(ray, vec3(0), vec3(0, 0, 1), 1.0));
        EXPECT_FALSE(intersectTorus(ray, 1.0, 0.5));
    }
    const Ray ray{{0.1, 0.2, 5}, {0, 0, -1}};
    for (const double size : {0.0, -1.0, notANumber}) {
        EXPECT_FALSE(intersectCylinder(ray, size, -1.0, 1.0));
        EXPECT_FALSE(intersectCone(ray, size, 1.0));
        EXPECT_FALSE(intersectCone(ray, 1.0, size));
        EXPECT_FALSE(intersectDisk(ray, vec3(0), vec3(0, 0, 1), size));
        EXPECT_FALSE(intersectTorus(ray, 1.0, size));
    }
    EXPECT_FALSE(intersectCylinder(ray, 1.0, 1.0, -1.0));
}

// A thin ring, a thousand of its tubes wide: the quartic's last coefficient is a product.
TEST(QuadricRayExtremes, a_ring_of_wire) {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const double turn = random.number(0, 2 * pi);
        const vec3 middle(std::cos(turn), 0, std::sin(turn));
        const Ray ray{middle + vec3(0, 3, 0) + 0.2 * random.point(1), vec3(0)};
        const Ray aimed{ray.origin, middle - ray.origin};
        const auto t = intersectTorus(aimed, 1.0, 1e-3);
        ASSERT_TRUE(t) << i;
        EXPECT_NEAR(offTorus(aimed.at(*t), 1, 1e-3), 0, 1e-12) << i;
    }
}
