#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <span>
#include <vector>

#include "mv/geometry/ray_forms.h"
#include "mv/math/transform.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

TEST(RayForms, the_planes_forms_agree) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const vec3 corner = random.point(5), along = random.direction(), up = random.direction(),
                   normal = glm::cross(along, up);
        if (glm::length(normal) < 0.1) continue;
        const Ray ray{random.point(5), random.direction()};
        if (std::abs(glm::dot(ray.direction, glm::normalize(normal))) < 0.1) continue;
        const auto byPoint = intersectPlane(ray, corner, normal);
        const auto bySystem = intersectPlane(ray, corner, along, up);
        ASSERT_EQ(byPoint.has_value(), bySystem.has_value());
        if (!byPoint) continue;
        // A hundredth of the numbers' size is divided by: 1e2 roundings of numbers up to 1e2
        EXPECT_NEAR(*byPoint, bySystem->t, 1e-11);
        EXPECT_LT(glm::distance(ray.at(bySystem->t), corner + bySystem->u * along + bySystem->v * up), 1e-10);
    }
    // Parallel, in the plane, behind, and two vectors along one line
    const Ray ray{{0, 1, 0}, {1, 0, 0}};
    EXPECT_FALSE(intersectPlane(ray, vec3(0), vec3(0, 1, 0)));
    EXPECT_FALSE(intersectPlane(ray, vec3(0, 1, 0), vec3(0, 1, 0)));
    EXPECT_FALSE(intersectPlane(ray, vec3(-1, 0, 0), vec3(1, 0, 0)));
    EXPECT_FALSE(intersectPlane(ray, vec3(0), vec3(0, 1, 0), vec3(0, 2, 0)));
    EXPECT_FALSE(intersectPlane(Ray{{0, std::nan(""), 0}, {1, 1, 0}}, vec3(2, 0, 0), vec3(1, 1, 0)));
}

TEST(RayForms, the_largest_component_is_left_out) {
    EXPECT_EQ(droppedAxis(vec3(-3, 2, 1)), 0);
    EXPECT_EQ(droppedAxis(vec3(1, -3, 2)), 1);
    EXPECT_EQ(droppedAxis(vec3(1, 2, -3)), 2);
    EXPECT_EQ(droppedAxis(vec3(1, 1, 1)), 0);
    EXPECT_EQ(without(1, vec3(1, 2, 3)), vec2(3, 1));
}

TEST(RayForms, polygons_that_share_edges_hold_each_point_once) {
    // A fan of eight triangles round a point, on a grid of quarters, and points of that grid
    const std::array<vec2, 8> rim{vec2(0, 0), vec2(2, 0), vec2(4, 0), vec2(4, 2),
                                  vec2(4, 4), vec2(2, 4), vec2(0, 4), vec2(0, 2)};
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const vec2 point(x / 4.0, y / 4.0);
            int times = 0;
            for (std::size_t i = 0; i < rim.size(); ++i) {
                const std::array<vec2, 3> piece{vec2(1.75, 2.25), rim.at(i), rim.at((i + 1) % rim.size())};
                times += isInside(std::span<const vec2>(piece), point);
            }
            ASSERT_EQ(times, 1) << x << " " << y;
        }
    }
    EXPECT_FALSE(isInside(std::span<const vec2>(rim), vec2(5, 2)));
    EXPECT_FALSE(isInside(std::span<const vec2>(), vec2(0, 0)));
}

// As near to an edge as doubles are: what lies between a point and its neighbour is decided, and by no rounded difference.
TEST(RayForms, a_point_beside_an_edge_by_less_than_a_rounding) {
    const std::array<vec2, 3> corners{vec2(0.9500000000001119, 0.9500000000001101), vec2(18, 18), vec2(18, 0.95)};
    const vec2 point(16.8, 16.8);
    // The edge's line is below the point by 9e-17, half of what its coordinates can say
    ASSERT_EQ(orientation(corners[0], corners[1], point), 1);
    EXPECT_FALSE(isInside(std::span<const vec2>(corners), point));

    // Either way round, and as a neighbour on the other side of the edge has it
    Random random(6);
    int byRounding = 0;
    for (int i = 0; i < 20'000; ++i) {
        const vec2 a(random.number(0, 1), random.number(0, 1)), b(random.number(17, 18), random.number(17, 18));
        const double along = random.number(0.01, 0.99);
        const vec2 at = a + along * (b - a);
        const std::array<vec2, 3> right{a, b, vec2(20, 0)}, turned{vec2(20, 0), b, a}, left{a, b, vec2(0, 20)};
        const int side = orientation(a, b, at);
        const auto holds = [&](const std::array<vec2, 3>& polygon) {
            return isInside(std::span<const vec2>(polygon), at);
        };
        ASSERT_EQ(holds(right), side <= 0) << i;
        ASSERT_EQ(holds(turned), side <= 0) << i;
        ASSERT_EQ(holds(left), side > 0) << i;
        const vec2 edge = b - a, way = at - a;
        const double rounded = differenceOfProducts(edge.x, way.y, edge.y, way.x);
        byRounding += (rounded > 0) != (side > 0) ? 1 : 0;
    }
    EXPECT_GT(byRounding, 1000) << "the differences of coordinates are rounded, so that form is a matter of luck here";
}

TEST(RayForms, polygons_in_space) {
    // An arrow, not convex, in a slanting plane
    const mat4 placed = translate(1, 2, -3) * rotateY(40) * rotateX(-25);
    const std::array<vec2, 4> flat{vec2(-1, -1), vec2(1, 0), vec2(-1, 1), vec2(-0.25, 0)};
    std::array<vec3, 4> arrow{};
    for (std::size_t i = 0; i < 4; ++i) arrow.at(i) = vec3(placed * vec4(flat.at(i), 0, 1));
    Random random(3);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec2 aim(random.number(-1.2, 1.2), random.number(-1.2, 1.2));
        const vec3 target(placed * vec4(aim, 0, 1)),
            eye(random.number(-2, 2), random.number(4, 6), random.number(2, 4));
        const auto t = intersectPolygon(Ray{eye, target - eye}, std::span<const vec3>(arrow));
        const bool isIn = isInside(std::span<const vec2>(flat), aim);
        ASSERT_EQ(t.has_value(), isIn) << aim.x << " " << aim.y;
        if (!t) continue;
        EXPECT_NEAR(*t, 1, 1e-12);
        ++hits;
    }
    EXPECT_GT(hits, 300);
    EXPECT_FALSE(intersectPolygon(Ray{}, std::span<const vec3>(arrow.data(), 2)));
    const std::vector<vec3> many(17, vec3(0)), line{vec3(0, 0, -1), vec3(1, 0, -1), vec3(2, 0, -1)};
    EXPECT_FALSE(intersectPolygon(Ray{}, std::span<const vec3>(many)));
    EXPECT_FALSE(intersectPolygon(Ray{}, std::span<const vec3>(line)));
}

TEST(RayForms, an_objects_space_keeps_t) {
    const mat4 worldFromObject = translate(3, -1, 2) * rotateZ(50) * scale(2, 0.5, 3),
               back = glm::inverse(worldFromObject);
    const Ray ray{{1, 2, 9}, {0.2, -0.3, -2}}, inside = transformed(ray, back);
    for (const double t : {0.0, 0.7, 3.0}) {
        EXPECT_LT(glm::distance(vec3(back * vec4(ray.at(t), 1)), inside.at(t)), 1e-13);
    }
    // A plane's normal stays at right angles to what lies in the plane
    const vec3 normal(1, 2, -1), along(2, -1, 0);
    EXPECT_NEAR(glm::dot(normalToWorld(normal, back), vec3(worldFromObject * vec4(along, 0))), 0, 1e-14);
}

TEST(RayForms, newtons_method_ends_on_the_surface) {
    // A saddle over the unit square
    const auto saddle = [](double u, double v) {
        return SurfaceAt<double>{{u, v, (u - 0.5) * (v - 0.5)}, {1, 0, v - 0.5}, {0, 1, u - 0.5}};
    };
    Random random(4);
    for (int i = 0; i < 500; ++i) {
        const double u = random.number(0.01, 0.99), v = random.number(0.01, 0.99);
        const vec3 eye(random.number(-1, 2), random.number(-1, 2), 3), target = saddle(u, v).point;
        const Ray ray{eye, target - eye};
        for (const auto& hit : {intersectSurface(ray, saddle, SurfaceHit<double>{0, 0.5, 0.5}),
                                intersectSurfaceFromGrid(ray, saddle, 4)}) {
            ASSERT_TRUE(hit);
            EXPECT_NEAR(hit->t, 1, 1e-13);
            EXPECT_NEAR(hit->u, u, 1e-12);
            EXPECT_NEAR(hit->v, v, 1e-12);
        }
    }
    const Ray beside{{2, 2, 3}, {0, 0, -1}}, away{{0.5, 0.5, 3}, {0, 0, 1}}, broken{{0, 0, 3}, {0, 0, std::nan("")}};
    for (const Ray& ray : {beside, away, broken}) {
        EXPECT_FALSE(intersectSurface(ray, saddle, SurfaceHit<double>{0, 0.5, 0.5}));
        EXPECT_FALSE(intersectSurfaceFromGrid(ray, saddle, 4));
    }
    EXPECT_FALSE(intersectSurfaceFromGrid(Ray{{0.5, 0.5, 3}, {0, 0, -1}}, saddle, 0));
    EXPECT_FALSE(intersectSurfaceFromGrid(Ray{{0.5, 0.5, 3}, {0, 0, -1}}, saddle, 65));
}

TEST(RayForms, a_start_beside_the_surface_is_on_the_asked_side) {
    for (const double size : {1e-3, 1.0, 1e6}) {
        const vec3 point = size * vec3(3, -2, 5), normal = glm::normalize(vec3(1, 2, 2));
        const vec3 above = besideSurface(point, normal, {0, 1, 0}, glm::abs(point), 8);
        const vec3 below = besideSurface(point, normal, {0, -1, 0}, glm::abs(point), 8);
        EXPECT_GT(glm::dot(above - point, normal), 0);
        EXPECT_LT(glm::dot(below - point, normal), 0);
        EXPECT_LT(glm::distance(above, point), 1e-13 * size);
    }
}
