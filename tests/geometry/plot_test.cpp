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

// Ascending, between the ends, and not too many: for the smallest, the largest and the narrowest ranges that there are
void expectTicks(const Axis& axis, int most) {
    SCOPED_TRACE(testing::Message() << axis.low << " to " << axis.high << ", " << most);
    const Values values = ticks(axis, most);
    EXPECT_LE(values.size(), std::size_t(most));
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_TRUE(std::isfinite(values[i]));
        EXPECT_GE(values[i] / 2, axis.low / 2 - 1e-9 * (axis.high / 2 - axis.low / 2));
        EXPECT_LE(values[i] / 2, axis.high / 2 + 1e-9 * (axis.high / 2 - axis.low / 2));
        if (i > 0) {
            EXPECT_GT(values[i], values[i - 1]);
        }
        if (axis.logarithmic) {
            EXPECT_GT(values[i], 0);
        }
    }
}

TEST(Plot, TicksOfAnyRange) {
    constexpr double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
    for (const int count : {1, 2, 4, 7, 1000}) {
        for (const double size :
             {least, 1e-320, 1e-310, 1e-307, 1e-300, 1e-3, 1.0, 3e15, 1e16, 1e300, most / 2, most}) {
            expectTicks({-size, size}, count);
            expectTicks({0, size}, count);
            if (size < most / 2) expectTicks({size, 2 * size}, count);
            for (const int roundings : {1, 2, 3, 10, 100}) {
                double low = size;
                for (int i = 0; i < roundings; ++i) low = std::nextafter(low, -1.0);
                expectTicks({low, size}, count);
                expectTicks({-size, -low}, count);
                if (low > 0) expectTicks({low, size, "", true}, count);
            }
            if (size > 1e-310) expectTicks({1e-310, size, "", true}, count);
            if (size > least) expectTicks({least, size, "", true}, count);
        }
        expectTicks({1 + 1e-10, 1 + 2e-10, "", true}, count);
    }
    EXPECT_EQ(ticks({1e-307, 2e-307}, 4), (Values{1e-307, 1.5e-307, 2e-307}));
    EXPECT_EQ(ticks({-1e308, 1e308}, 5), (Values{-1e308, -5e307, 0, 5e307, 1e308}));
    EXPECT_EQ(ticks({1, std::nextafter(1, 2)}, 4), (Values{1, std::nextafter(1, 2)}));
    EXPECT_EQ(ticks({0, least}, 4), (Values{0, least}));
    EXPECT_EQ(ticks({1e-310, 1e-308, "", true}, 4), (Values{1e-310, 1e-309, 1e-308}));
    // Where a value is drawn does not overflow either
    const Plot plot{{{0, 0}, {200, 100}}, {-1e308, 1e308}, {-most, most}};
    EXPECT_EQ(plot.pixel({0, 0}), vec2(100, 50));
    EXPECT_EQ(plot.pixel({-1e308, most}), vec2(0, 100));
    EXPECT_EQ(plot.value({150, 50}), vec2(5e307, 0));
    EXPECT_EQ(plot.value({200, 100}), vec2(1e308, most));
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
