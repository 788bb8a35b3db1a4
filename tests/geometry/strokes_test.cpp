#include "mv/geometry/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mv/error.h"

using namespace mv;

namespace {

const vec4 red(1, 0, 0, 1);

// The colour's alpha at a point, all triangles there added; what GL draws where nothing overlaps.
double alphaAt(const Painted& painted, const vec2& point) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < painted.size(); i += 3) {
        const vec2 a(painted[i].position), b(painted[i + 1].position), c(painted[i + 2].position);
        const auto area = [](const vec2& p, const vec2& q, const vec2& r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        const double whole = area(a, b, c);
        if (whole == 0) continue;
        const vec3 part = vec3(area(point, b, c), area(a, point, c), area(a, b, point)) / whole;
        if (std::min({part.x, part.y, part.z}) < 0) continue;
        sum += part.x * painted[i].color.a + part.y * painted[i + 1].color.a + part.z * painted[i + 2].color.a;
    }
    return sum;
}

// How much is painted, in pixels: the alpha over the area of all triangles.
double painted(const Painted& all) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
        const vec2 b = vec2(all[i + 1].position) - vec2(all[i].position),
                   c = vec2(all[i + 2].position) - vec2(all[i].position);
        const double alpha = all[i].color.a + all[i + 1].color.a + all[i + 2].color.a;
        sum += std::abs(b.x * c.y - b.y * c.x) / 2 * alpha / 3;
    }
    return sum;
}

TEST(Strokes, ALineCoversItsWidthTimesItsLengthInAnyDirection) {
    for (const double width : {0.5, 1.0, 1.5, 4.0}) {
        for (const double angle : {0.0, 17.0, 45.0, 90.0, 143.0}) {
            const vec2 along(std::cos(radians(angle)), std::sin(radians(angle)));
            Painted line;
            strokeLine(line, std::array{vec3(vec2(32) - 20.0 * along, 0), vec3(vec2(32) + 20.0 * along, 0)}, width,
                       red);
            // The four corners, where a side and an end both fade, are a third of a pixel's corner each off
            EXPECT_NEAR(painted(line), 40 * width, 0.5) << width << " px, " << angle << " deg";
        }
    }
}

TEST(Strokes, WholeCoordinatesHaveSharpEdges) {
    Painted box, line;
    fillConvex(box, std::array{vec2(4, 4), vec2(9, 4), vec2(9, 7), vec2(4, 7)}, 0, red);
    strokeLine(line, std::array{vec3(4, 5.5, 0), vec3(9, 5.5, 0)}, 1, red);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x) {
            const vec2 middle(x + 0.5, y + 0.5);
            const bool inBox = x >= 4 && x < 9 && y >= 4 && y < 7, inLine = x >= 4 && x < 9 && y == 5;
            // On a diagonal of two triangles both count
            EXPECT_EQ(alphaAt(box, middle) > 0.999, inBox) << x << ", " << y;
            EXPECT_EQ(alphaAt(box, middle) > 0.001, inBox) << x << ", " << y;
            EXPECT_EQ(alphaAt(line, middle) > 0.999, inLine) << x << ", " << y;
            EXPECT_EQ(alphaAt(line, middle) > 0.001, inLine) << x << ", " << y;
        }
    }
}

TEST(Strokes, CornersAreFilledAndNotLongerThanTheWidth) {
    for (const double turn : {10.0, 60.0, 89.0, 91.0, 150.0, 179.0}) {
        SCOPED_TRACE(turn);
        const vec2 corner(32), out = 20.0 * vec2(std::cos(radians(turn)), std::sin(radians(turn)));
        Painted line;
        strokeLine(line, std::array{vec3(12, 32, 0), vec3(corner, 0), vec3(corner + out, 0)}, 6, red);
        EXPECT_GT(alphaAt(line, corner + vec2(0.01, 0.02)), 0.999);
        // On the outer side of the corner, 2 px out, where two straight ends alone would leave a wedge
        const vec2 outer = glm::normalize(vec2(1, 0) - glm::normalize(out));
        EXPECT_GT(alphaAt(line, corner + 2.0 * outer), 0.999);
        double farthest = 0;
        for (const PaintedVertex& vertex : line) {
            const vec2 from = vec2(vertex.position) - corner;
            if (glm::length(from) < 15) farthest = std::max(farthest, glm::length(from));
        }
        EXPECT_LT(farthest, 3.5 * std::sqrt(2.0) + 1);  // half the width and the rim, at a right angle
    }
}

TEST(Strokes, PolygonsCoverTheirAreaInEitherWinding) {
    std::vector<vec2> corners = circle({32, 32}, 10);
    Painted disc, turned;
    fillConvex(disc, corners, 0, red);
    std::reverse(corners.begin(), corners.end());
    fillConvex(turned, corners, 0, red);
    EXPECT_NEAR(painted(disc), pi * 100, 0.1 * 2 * pi * 10);  // the rim is a tenth of a pixel within the circle at most
    EXPECT_NEAR(painted(turned), painted(disc), 1e-9);
    for (const double radius : {0.5, 3.0, 100.0, 3000.0}) {
        const std::vector<vec2> ring = circle({0, 0}, radius);
        EXPECT_NEAR(glm::length(ring[0] + ring[1]) / 2, radius, 0.1);
        EXPECT_GE(ring.size(), 8U);
    }
}

TEST(Strokes, AThinPolygonIsTheSameFarFromTheOrigin) {
    for (const double width : {0x1p-4, 0x1p-10, 0x1p-18}) {
        for (const bool isTurned : {false, true}) {
            std::vector<vec2> corners{{0, 0}, {10, 3}, {10, 3 + width}, {0, width}};
            if (isTurned) std::reverse(corners.begin(), corners.end());
            Painted near, far;
            fillConvex(near, corners, 0, red);
            const vec2 away(0x1p30, 0x1p29);  // exact: 2^-18 is no less than a double's step there
            for (vec2& corner : corners) corner += away;
            fillConvex(far, corners, 0, red);
            ASSERT_EQ(near.size(), far.size()) << width;
            for (std::size_t i = 0; i < near.size(); ++i) {
                // The rim's corners are rounded to that step
                EXPECT_LT(glm::distance(vec2(near[i].position), vec2(far[i].position) - away), 0x1p-20) << width;
                EXPECT_EQ(near[i].color, far[i].color);
            }
        }
    }
}

TEST(Strokes, CuttingKeepsWhatIsInside) {
    Painted all;
    strokeLine(all, std::array{vec3(-50, 10, -1), vec3(60, 43, 1)}, 5, red);
    fillConvex(all, circle({30, 30}, 12), 0, vec4(0, 1, 0, 0.5));
    Painted cut = all;
    const Box box{{8, 9}, {33, 31}};
    cutTo(cut, 0, box);
    for (const PaintedVertex& vertex : cut) {
        EXPECT_TRUE(Box({box.low - 1e-9, box.high + 1e-9}).holds(vec2(vertex.position)));
        EXPECT_GE(vertex.position.z, -1);
        EXPECT_LE(vertex.position.z, 1);
    }
    for (const vec2& point : {vec2(9.1, 28.03), vec2(20.2, 30.3), vec2(12.3, 28.9), vec2(32.9, 30.9), vec2(25.5, 25.3)})
        EXPECT_NEAR(alphaAt(cut, point), alphaAt(all, point), 1e-9);
    EXPECT_EQ(alphaAt(cut, {33.5, 30}), 0);
    // Strokes from before are left alone, and those that are whole inside, too
    Painted both = all;
    const std::size_t first = both.size();
    fillConvex(both, circle({20, 20}, 3), 0, red);
    const Painted before = both;
    cutTo(both, first, box);
    ASSERT_EQ(both.size(), before.size());
    for (std::size_t i = 0; i < both.size(); ++i) EXPECT_EQ(both[i].position, before[i].position);
    cutTo(both, 0, {vec2(100), vec2(101)});
    EXPECT_TRUE(both.empty());
}

TEST(Strokes, DepthsFollowALine) {
    Painted line;
    strokeLine(line, std::array{vec3(0, 0, -0.5), vec3(10, 0, 0.5)}, 2, red);
    for (const PaintedVertex& vertex : line) EXPECT_NEAR(vertex.position.z, vertex.position.x < 5 ? -0.5 : 0.5, 1e-12);
}

TEST(Strokes, WhatHasNoExtentHasNoTriangles) {
    Painted none;
    strokeLine(none, {}, 2, red);
    strokeLine(none, std::array{vec3(3, 4, 0), vec3(3, 4, 1)}, 2, red);
    fillConvex(none, std::array{vec2(1, 1), vec2(2, 2)}, 0, red);
    fillConvex(none, std::array{vec2(1, 1), vec2(2, 2), vec2(4, 4)}, 0, red);
    EXPECT_TRUE(none.empty());
    // And what is thin stays finite
    Painted thin;
    fillConvex(thin, std::array{vec2(0, 0), vec2(100, 0), vec2(100, 1e-9)}, 0, red);
    EXPECT_LT(painted(thin), 200);
    for (const PaintedVertex& vertex : thin) EXPECT_TRUE(std::isfinite(vertex.position.x + vertex.position.y));
}

TEST(Strokes, RefuseWhatIsNoNumber) {
    Painted none;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(strokeLine(none, std::array{vec3(0), vec3(1, nan, 0)}, 1, red), Error);
    EXPECT_THROW(strokeLine(none, std::array{vec3(0), vec3(1)}, 0, red), Error);
    EXPECT_THROW(fillConvex(none, std::array{vec2(0), vec2(1, 0), vec2(nan, 1)}, 0, red), Error);
    EXPECT_TRUE(none.empty());
}

}  // namespace
