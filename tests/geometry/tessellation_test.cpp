#include "mv/geometry/tessellation.h"

#include "../math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

TEST(Tessellation, LevelsStayInRange) {
    EXPECT_EQ(levelInRange(17.5), 17.5);
    EXPECT_EQ(levelInRange(1), 1);
    EXPECT_EQ(levelInRange(64), 64);
    for (const double low : {0.0, -3.0, 0.99, -infinite, notANumber}) EXPECT_EQ(levelInRange(low), 1) << low;
    for (const double high : {65.0, 1e30, infinite}) EXPECT_EQ(levelInRange(high), 64) << high;
}

TEST(Tessellation, AnEdgeHasOneLevelFromBothEnds) {
    std::uint32_t seed = 7;
    const auto number = [&] { return (seed = seed * 1664525U + 1013904223U) / 4294967296.0 - 0.5; };
    for (int i = 0; i < 1000; ++i) {
        const vec3 a(number(), number(), number()), b(number(), number(), number()), eye(0, 0, 2);
        EXPECT_EQ(edgeLevel(a, b, eye, 20), edgeLevel(b, a, eye, 20));
    }
}

TEST(Tessellation, AnEdgeFartherAwayOrShorterHasALowerLevel) {
    const vec3 a(-1, 0, 0), b(1, 0, 0);
    EXPECT_EQ(edgeLevel(a, b, {0, 0, 4}, 20), 10);
    EXPECT_EQ(edgeLevel(a, b, {0, 0, 8}, 20), 5);
    EXPECT_EQ(edgeLevel(0.5 * a, 0.5 * b, {0, 0, 4}, 20), 5);
    EXPECT_EQ(edgeLevel(a, b, {0, 0, 0}, 20), 64) << "the eye is in its middle";
    EXPECT_EQ(edgeLevel(a, a, {0, 0, 4}, 20), 1);
    EXPECT_EQ(edgeLevel(a, a, a, 20), 1) << "0/0";
}

TEST(Tessellation, TrianglesOfASquare) {
    for (int n = 1; n <= 64; ++n) EXPECT_EQ(trianglesOfSquare(n, n), 2L * n * n);
    EXPECT_EQ(trianglesOfSquare(2.5, 3), 18) << "rounded up";
    EXPECT_EQ(trianglesOfSquare(2, 1), 4) << "a point within four sides";
    EXPECT_EQ(trianglesOfSquare(1, 4), 16) << "an inner 1 is a 2";
    EXPECT_EQ(trianglesOfSquare(9, {4, 5, 6, 9}), 2 * 7 * 7 + 24 + 4 * 7) << "cells within, and four sides round them";
    EXPECT_EQ(trianglesOfSquare(1, {1, 1, 1, 2}), 5) << "the last of them in two";
    EXPECT_EQ(refusal([] {
                  trianglesOfSquare(4, {4, 4, 65, 4});
              }),
              "trianglesOfSquare: must have levels in 1 .. 64, 65");
    EXPECT_EQ(refusal([] { trianglesOfSquare(0, 4); }), "trianglesOfSquare: must have levels in 1 .. 64, 0");
    EXPECT_EQ(refusal([] { trianglesOfSquare(4, 65); }), "trianglesOfSquare: must have levels in 1 .. 64, 65");
    EXPECT_EQ(refusal([] { trianglesOfSquare(notANumber, 4); }), "trianglesOfSquare: must have levels in 1 .. 64, nan");
}

}  // namespace
