#include "mv/geometry/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mv/error.h"

using namespace mv;

namespace {

using Values = std::vector<double>;

TEST(Plot, PixelsAndValuesAreInverse) {
    const Plot plot{{{40, 30}, {240, 130}}, {0.1, 1e4, "distance", true}, {-2, 8}};
    EXPECT_EQ(plot.pixel({0.1, -2}), vec2(40, 30));
    EXPECT_EQ(plot.pixel({1e4, 8}), vec2(240, 130));
    for (const vec2& value : {vec2(1, 0), vec2(33, 7.7), vec2(1e6, -50), vec2(1e-3, 1e3)}) {
        const vec2 back = plot.value(plot.pixel(value));
        EXPECT_NEAR(back.x / value.x, 1, 1e-13);  // five roundings of up to 20, as a logarithm
        EXPECT_NEAR(back.y, value.y, 1e-12);
    }
    // A decade is as wide as each other one
    EXPECT_NEAR(plot.pixel({10, 0}).x - plot.pixel({1, 0}).x, 200.0 / 5, 1e-12);
    EXPECT_THROW(plot.pixel({0, 0}), Error);
    EXPECT_THROW((Plot{{{0, 0}, {1, 1}}, {3, 3}, {0, 1}}.pixel({3, 0})), Error);
}

TEST(Plot, TicksAreRoundNumbers) {
    EXPECT_EQ(ticks({0, 1}, 11), (Values{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}));
    EXPECT_EQ(ticks({0, 1}, 10), (Values{0, 0.2, 0.4, 0.6, 0.8, 1}));
    EXPECT_EQ(ticks({-0.3, 0.25}, 3), (Values{-0.2, 0, 0.2}));
    EXPECT_EQ(ticks({-7, 1234}, 4), (Values{0, 500, 1000}));
    EXPECT_EQ(ticks({3, 4}, 1), Values{4});
    for (const double size : {1e-7, 0.37, 12.0, 9.9e8}) {
        for (const double low : {-3.3 * size, 0.0, 0.1 * size, 200 * size}) {
            for (const int most : {1, 2, 5, 20}) {
                SCOPED_TRACE(std::to_string(low) + " + " + std::to_string(size) + ", " + std::to_string(most));
                const Values values = ticks({low, low + size}, most);
                EXPECT_LE(values.size(), std::size_t(most));
                EXPECT_GE(5 * values.size() + 4, std::size_t(most))
                    << "a step of half the size would be five times as many";
                for (const double value : values) {
                    EXPECT_GE(value, low - 1e-8 * size);
                    EXPECT_LE(value, low + size + 1e-8 * size);
                }
            }
        }
    }
}

TEST(Plot, TicksOfALogarithmAreDecades) {
    EXPECT_EQ(ticks({0.1, 1e4, "", true}, 10), (Values{0.1, 1, 10, 100, 1e3, 1e4}));
    EXPECT_EQ(ticks({0.1, 1e4, "", true}, 3), (Values{0.1, 10, 1e3}));
    EXPECT_EQ(ticks({2, 9, "", true}, 3), Values{});
    EXPECT_LE(ticks({1e-300, 1e300, "", true}, 7).size(), 7U);
}

TEST(Plot, TicksRefuseWhatHasNone) {
    EXPECT_THROW(ticks({1, 1}, 3), Error);
    EXPECT_THROW(ticks({2, 1}, 3), Error);
    EXPECT_THROW(ticks({0, 1}, 0), Error);
    EXPECT_THROW(ticks({0, 1, "", true}, 3), Error);
    EXPECT_THROW(ticks({0, std::numeric_limits<double>::infinity()}, 3), Error);
}

TEST(Plot, TickWords) {
    EXPECT_EQ(tickText(0.1 + 0.2), "0.3");
    EXPECT_EQ(tickText(-0.0), "0");
    EXPECT_EQ(tickText(1e6), "1e6");
    EXPECT_EQ(tickText(2.5e-7), "2.5e-7");
    EXPECT_EQ(tickText(10000), "10000");
}

}  // namespace
