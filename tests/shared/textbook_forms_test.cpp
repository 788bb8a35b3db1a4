// The slides' formulas for rays: as printed they fail, and as demos/ray-cast/textbook_forms.h has them they do not.
#include "ray-cast/textbook_forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>

#include "mv/math/transform.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

TEST(TextbookForms, plane_with_its_coefficients) {
    // 2x + 3y - z - 4 = 0 and a ray that meets it at t = 2
    const vec4 plane(2, 3, -1, -4);
    const vec3 at(1, 1, 1), way(0.5, -1, 3);
    const Ray ray{at - 2.0 * way, way};
    ASSERT_EQ(glm::dot(vec3(plane), at) + plane.w, 0);
    EXPECT_NEAR(*textbook::plane(ray, plane), 2, 1e-14);
    // Printed: -(x0 + y0 + z0 + D) / (Ax + By + Cz)
    const double printed = -(ray.origin.x + ray.origin.y + ray.origin.z + plane.w) / glm::dot(vec3(plane), way);
    EXPECT_GT(std::abs(printed - 2), 1);
    EXPECT_EQ(textbook::plane(ray, plane, textbook::Print::asPrinted).value_or(0), std::max(printed, 0.0));
}

TEST(TextbookForms, second_barycentric) {
    Random random(9);
    int printedFails = 0;
    for (int i = 0; i < 200; ++i) {
        const vec2 a(random.number(0, 1), random.number(0, 1)), b(random.number(3, 4), random.number(0, 1)),
            c(random.number(0, 3), random.number(3, 4));
        const vec3 weights = glm::normalize(vec3(random.number(0.1, 1), random.number(0.1, 1), random.number(0.1, 1)));
        const double sum = weights.x + weights.y + weights.z;
        const vec2 p = (weights.x * a + weights.y * b + weights.z * c) / sum;
        const Ray ray{{p, 5}, {0, 0, -1}};
        const auto hit = textbook::triangle(ray, vec3(a, 0), vec3(b, 0), vec3(c, 0));
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->b, weights.y / sum, 1e-13);
        const double below = (a.x - c.x) * (b.y - c.y) - (b.x - c.x) * (a.y - c.y);
        const double printed = (-(a.y - c.y) * (p.x - c.x) - (a.x - c.x) * (p.y - c.y)) / below;
        printedFails += std::abs(printed - weights.y / sum) > 0.01;
        const auto asPrinted = textbook::triangle(ray, vec3(a, 0), vec3(b, 0), vec3(c, 0), textbook::Print::asPrinted);
        const double third = 1 - hit->a - printed;
        ASSERT_EQ(asPrinted.has_value(), printed >= 0 && third >= 0);
        if (asPrinted) {
            EXPECT_NEAR(asPrinted->b, printed, 1e-12);
        }
    }
    EXPECT_GT(printedFails, 190);
}

TEST(TextbookForms, which_way_a_triangle_faces) {
    // Counter-clockwise, seen from +z
    const vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_GT(glm::cross(b - a, c - a).z, 0);
    EXPECT_LT(glm::cross(c - a, b - a).z, 0);  // printed: inwards
}

TEST(TextbookForms, a_ray_without_x_is_vertical) {
    // A box whose x reaches from 1 to 2, and a ray straight downwards: whether it meets the box is whether x0 is within
    const vec2 low(1, 0), high(2, 1);
    for (const double x : {0.5, 1.5, 2.5}) {
        const Ray ray{{x, 3, 0.5}, {0, -1, 0}};
        EXPECT_EQ(textbook::box(ray, vec3(low, 0), vec3(high, 1)).has_value(), x >= low.x && x <= high.x) << x;
        // Taken for a horizontal ray it would be asked for its height, and miss whatever it meets
        const bool asHorizontal = ray.origin.y >= low.y && ray.origin.y <= high.y;
        EXPECT_FALSE(asHorizontal);
    }
}

TEST(TextbookForms, the_middle_of_a_pixel) {
    // The rays of a picture 4 pixels wide, from left to right, are symmetrical; printed, i - width/2, they are not
    constexpr int width = 4;
    double sum = 0, printed = 0;
    for (int i = 0; i < width; ++i) {
        sum += i + 0.5 - width / 2.0;
        printed += i - width / 2.0;
    }
    EXPECT_EQ(sum, 0);
    EXPECT_EQ(printed / width, -0.5);
}

TEST(TextbookForms, a_cylinder_is_no_circle) {
    // (cos u, v, sin u): both tangents span an area; printed with a constant height h there is one tangent only
    const double u = 0.7;
    const vec3 alongU(-std::sin(u), 0, std::cos(u)), alongV(0, 1, 0), printedAlongV(0, 0, 0);
    EXPECT_NEAR(glm::length(glm::cross(alongU, alongV)), 1, 1e-15);
    EXPECT_EQ(glm::length(glm::cross(alongU, printedAlongV)), 0);
}

TEST(TextbookForms, crossings_half_open_in_the_height) {
    const std::array<vec2, 3> triangle{vec2(2, 0), vec2(3, 1), vec2(1, 1)};
    const std::span<const vec2> corners(triangle);
    EXPECT_FALSE(isInside(corners, vec2(0, 0)));
    // Half-open in s the corner (2, 0) is counted with one edge of its two, and (0, 0) is inside
    int crossings = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const vec2 from = triangle.at(i), to = triangle.at((i + 1) % 3);
        if (from.y == to.y) continue;
        const double s = (0 - from.y) / (to.y - from.y);
        crossings += s >= 0 && s < 1 && from.x + s * (to.x - from.x) > 0;
    }
    EXPECT_EQ(crossings % 2, 1);
    // Closed, as printed, a corner that is passed sideways is counted twice: a point left of it is outside
    const std::array<vec2, 4> square{vec2(0, 0), vec2(2, -2), vec2(4, 0), vec2(2, 2)};
    EXPECT_TRUE(isInside(std::span<const vec2>(square), vec2(1, 0)));
    EXPECT_FALSE(textbook::isInside(std::span<const vec2>(square), vec2(1, 0)));
}

TEST(TextbookForms, an_objects_ray_keeps_its_length) {
    // Two unit balls, one made three times as large: normalized anew, its t is that of another space, and it seems nearer
    const mat4 large = translate(0, 0, -20) * scale(3, 3, 3), small = translate(0, 0, -12);
    const Ray ray{{0, 0, 0}, {0, 0, -1}};
    const auto keeps = [&](const mat4& placed) {
        return intersectSphere(transformed(ray, glm::inverse(placed)), vec3(0), 1.0)->near;
    };
    const auto slip = [&](const mat4& placed) {
        Ray inside = transformed(ray, glm::inverse(placed));
        inside.direction = glm::normalize(inside.direction);
        return intersectSphere(inside, vec3(0), 1.0)->near;
    };
    EXPECT_NEAR(keeps(small), 11, 1e-13);
    EXPECT_NEAR(keeps(large), 17, 1e-13);
    EXPECT_LT(slip(large), slip(small));
    // And with a formula that takes a = 1 for granted
    const Ray inside = transformed(ray, glm::inverse(large));
    const double b = glm::dot(inside.origin, inside.direction), c = glm::dot(inside.origin, inside.origin) - 1;
    EXPECT_FALSE(b * b - c >= 0);  // it misses
    EXPECT_TRUE(textbook::sphere(inside, vec3(0), 1.0));
}
