#include "z-buffer/depth_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mv/error.h"
#include "mv/math/projection.h"

using namespace mv;

namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST(DepthOrder, window_depth_is_the_formulas_with_float_roundings) {
    const double near = 0.5, far = 20;
    const fmat4 clip(perspective(50, 1, near, far));
    for (const double d : {0.5, 0.7, 1.0, 5.0, 19.0, 20.0}) {
        const double right = far / (far - near) * (1 - near / d);
        // Six roundings of 2^-25 each, of numbers up to 1
        EXPECT_NEAR(windowDepth(clip, float(d), false), right, 6 * std::ldexp(1, -25)) << d;
        EXPECT_NEAR(windowDepth(clip, float(d), true), 2 * right - 1, 6 * std::ldexp(1, -24)) << d;
    }
}

TEST(DepthOrder, kept_depth_is_the_nearest_step) {
    const float third = 1.0F / 3;
    EXPECT_EQ(keptDepth(DepthFormat::d32f, third), third);
    EXPECT_EQ(keptDepth(DepthFormat::d16, third), 21845.0 / 65535);
    EXPECT_EQ(keptDepth(DepthFormat::d24, third), 5592405.0 / 16777215);
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        EXPECT_EQ(keptDepth(format, -0.5F), 0);
        EXPECT_EQ(keptDepth(format, 1.5F), 1);
    }
    // Half a step of 16 bits is where the next one begins.
    EXPECT_EQ(keptDepth(DepthFormat::d16, 0.49F / 65535), 0);
    EXPECT_EQ(keptDepth(DepthFormat::d16, 0.51F / 65535), 1.0 / 65535);
}

TEST(DepthOrder, misordered_are_equal_and_turned_pairs) {
    const auto identity = [](float z) { return double(z); };
    EXPECT_EQ(sum(misorderedPairs(0.1, 100, 1e-3, 1000, identity)), 0);
    EXPECT_EQ(sum(misorderedPairs(0.1, 100, 1e-3, 1000, [](float z) { return -double(z); })), 1000);
    EXPECT_EQ(sum(misorderedPairs(0.1, 100, 1e-3, 1000, [](float) { return 0.5; })), 1000);
    EXPECT_EQ(sum(misorderedPairs(0.1, 100, 0, 1000, identity)), 1000);
    // In equal ratios: a third of the pairs in each of the three decades; and the farther one stays before far.
    long below = 0;
    float last = 0;
    misorderedPairs(0.1, 100, 1e-3, 1000, [&](float z) {
        below += z < 1 ? 1 : 0;
        last = std::max(last, z);
        return double(z);
    });
    EXPECT_NEAR(double(below), 2 * 1000 / 3.0, 2);
    EXPECT_LE(last, 100);
    EXPECT_GT(last, 99);
}

TEST(DepthOrder, impossible_ranges_are_refused) {
    const auto depth = [](float z) { return double(z); };
    EXPECT_THROW(misorderedPairs(0, 1, 0, 10, depth), Error);
    EXPECT_THROW(misorderedPairs(1, 1, 0, 10, depth), Error);
    EXPECT_THROW(misorderedPairs(1, 1.5, 1, 10, depth), Error);
    EXPECT_THROW(misorderedPairs(1, 2, -0.1, 10, depth), Error);
    EXPECT_THROW(misorderedPairs(1, 2, 0, 0, depth), Error);
}
