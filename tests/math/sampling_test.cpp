#include "mv/math/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "mv/error.h"

using namespace mv;

TEST(JitteredSquare, one_point_in_each_cell) {
    for (const int side : {1, 2, 7, 32}) {
        const auto points = jitteredSquare(side, 15);
        std::set<std::pair<int, int>> cells;
        for (const vec2& point : points) {
            EXPECT_GE(std::min(point.x, point.y), 0);
            EXPECT_LT(std::max(point.x, point.y), 1);
            cells.emplace(int(point.x * side), int(point.y * side));
        }
        EXPECT_EQ(points.size(), static_cast<std::size_t>(side * side));
        EXPECT_EQ(cells.size(), points.size());
    }
}

// The documented order of the error for a function with an edge: n^-3/4, where merely random points have n^-1/2.
TEST(JitteredSquare, converges_faster_than_random_points) {
    const auto rms = [](int side) {
        double squares = 0;
        for (std::uint32_t seed = 0; seed < 200; ++seed) {
            double inside = 0;
            for (const vec2& p : jitteredSquare(side, seed)) inside += p.x + 0.6 * p.y < 0.7 ? 1 : 0;
            // The edge leaves the square at x = 0.7 below and at x = 0.1 above: a trapezium of area 0.4.
            squares += std::pow(inside / (side * side) - 0.4, 2);
        }
        return std::sqrt(squares / 200);
    };
    const double slope = std::log(rms(32) / rms(4)) / std::log(64.0);
    // 200 seeds know each rms to 1/sqrt(400) = 5 %, so the slope to 0.07 / log(64) = 0.02; three of these.
    EXPECT_NEAR(slope, -0.75, 0.06);
}

TEST(JitteredSquare, the_same_numbers_everywhere) {
    EXPECT_EQ(jitteredSquare(3, 15), jitteredSquare(3, 15));
    EXPECT_NE(jitteredSquare(3, 15), jitteredSquare(3, 16));
    // The standard says which number the 10000th of seed 5489 is: 4123659995. The point is the 5000th; this is its y.
    const vec2 point = jitteredSquare(71, 5489)[4999];
    const double jitter = point.y * 71 - std::floor(point.y * 71);
    EXPECT_NEAR(jitter, 4123659995.0 / 4294967296.0, 1e-13);  // 71 units hold 1e-14
}

TEST(JitteredSquare, refuses_other_numbers) {
    for (const int side : {0, -1, 1025}) {
        try {
            jitteredSquare(side, 1);
            ADD_FAILURE() << side;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("side must be 1 to 1024"), std::string::npos) << error.what();
        }
    }
}
