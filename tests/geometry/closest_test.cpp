#include "mv/geometry/closest.h"

#include "math/support.h"

using namespace mv;
using namespace mv::test;

TEST(Closest, the_difference_is_perpendicular) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const vec3 p = random.point(10), a = random.point(10), b = random.point(10);
        const vec3 onLine = closestOnLine(p, a, b), onSegment = closestOnSegment(p, a, b);
        EXPECT_NEAR(glm::dot(p - onLine, glm::normalize(b - a)), 0, 1e-13);
        EXPECT_LT(glm::length(glm::cross(onLine - a, glm::normalize(b - a))), 1e-13);
        const double along = glm::dot(p - a, b - a) / glm::dot(b - a, b - a);
        if (along < 0) {
            EXPECT_EQ(onSegment, a);
        } else if (along > 1) {
            EXPECT_EQ(onSegment, b);
        } else {
            EXPECT_LT(glm::distance(onSegment, onLine), 1e-13);
        }
        const vec4 plane(random.point(3), random.number(-5, 5));
        const vec3 onPlane = closestOnPlane(p, plane);
        EXPECT_NEAR(glm::dot(plane, vec4(onPlane, 1)), 0, 1e-13);
        EXPECT_LT(glm::length(glm::cross(p - onPlane, glm::normalize(vec3(plane)))), 1e-12);
    }
}

// Nothing of the triangle is nearer, and the point is of the triangle.
TEST(Closest, no_point_of_the_triangle_is_nearer) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const vec3 p = random.point(2), a = random.point(1), b = random.point(1), c = random.point(1);
        const vec3 near = closestOnTriangle(p, a, b, c);
        const double distance = glm::distance(p, near);
        for (int k = 0; k < 50; ++k) {
            double u = random.number(0, 1), v = random.number(0, 1);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            EXPECT_GE(glm::distance(p, a + u * (b - a) + v * (c - a)), distance - 1e-14);
        }
        // As a sum of the corners: weights of at least 0
        const vec3 normal = glm::cross(b - a, c - a);
        EXPECT_NEAR(glm::dot(glm::normalize(normal), near - a), 0, 1e-14);
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            EXPECT_GE(glm::dot(glm::normalize(normal), glm::cross(to - from, near - from)), -1e-14);
        EXPECT_LT(glm::distance(closestOnTriangle(p, c, b, a), near), 1e-13);  // whichever way round
    }
}

TEST(Closest, corners_edges_and_the_inside) {
    const vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
    EXPECT_EQ(closestOnTriangle({1, 1, 5}, a, b, c), vec3(1, 1, 0));
    EXPECT_EQ(closestOnTriangle({-1, -1, 5}, a, b, c), a);
    EXPECT_EQ(closestOnTriangle({9, 1, 0}, a, b, c), b);
    EXPECT_EQ(closestOnTriangle({1, -3, 2}, a, b, c), vec3(1, 0, 0));
    EXPECT_EQ(closestOnTriangle({3, 3, 1}, a, b, c), vec3(2, 2, 0));
}

TEST(ClosestExtremes, without_area_slender_and_far_away) {
    // A line, and a point
    EXPECT_EQ(closestOnTriangle({2, 3, 0}, {0, 0, 0}, {1, 0, 0}, {4, 0, 0}), vec3(2, 0, 0));
    EXPECT_EQ(closestOnTriangle({2, 3, 0}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}), vec3(1));
    EXPECT_EQ(closestOnSegment({5, 5, 5}, {1, 1, 1}, {1, 1, 1}), vec3(1));
    // 1 long and 1e-12 high: the nearest is within that of the long edge
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const double x = random.number(0.1, 0.9);
        const vec3 near = closestOnTriangle({x, random.number(-1, 1), random.number(-1, 1)}, {0, 0, 0}, {1, 0, 0},
                                            {random.number(0.3, 0.7), 1e-12, 0});
        EXPECT_LT(glm::distance(near, vec3(x, 0, 0)), 5e-12);  // its own height, and 3.3 times that along its slope
    }
    // A million triangles away from the origin the differences are still exact
    const vec3 far(0x1p40, -0x1p41, 0x1p39);
    EXPECT_EQ(closestOnTriangle(far + vec3(1, 1, 5), far, far + vec3(4, 0, 0), far + vec3(0, 4, 0)),
              far + vec3(1, 1, 0));
    for (const double size : {1e-70, 1e70}) {
        const vec3 near = closestOnTriangle(size * vec3(1, 1, 5), vec3(0), size * vec3(4, 0, 0), size * vec3(0, 4, 0));
        EXPECT_LT(glm::distance(near / size, vec3(1, 1, 0)), 1e-15);
    }
}

TEST(Closest, refusals_say_what_would_have_been_right) {
    EXPECT_EQ(refusal([] {
                  closestOnLine({0, 0, 0}, {1, 2, 3}, {1, 2, 3});
              }),
              "closestOnLine: a and b must differ, (1, 2, 3)");
    EXPECT_EQ(refusal([] {
                  closestOnPlane({0, 0, 0}, {0, 0, 0, 1});
              }),
              "closestOnPlane: the normal must not be 0, (0, 0, 0, 1)");
    EXPECT_EQ(refusal([] {
                  closestOnTriangle({0, 0, 0}, {notANumber, 0, 0}, {0, 0, 0}, {0, 0, 0});
              }),
              "closestOnTriangle: a corner must be finite, (nan, 0, 0)");
    EXPECT_EQ(refusal([] {
                  closestOnSegment({0, 0, infinite}, {0, 0, 0}, {0, 0, 0});
              }),
              "closestOnSegment: the point must be finite, (0, 0, inf)");
}
