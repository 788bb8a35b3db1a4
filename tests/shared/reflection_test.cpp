#include "shading/reflection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "../math/support.h"

using namespace mv;
using namespace mv::test;

namespace {
vec3 at(double degrees) { return {std::sin(radians(degrees)), 0, std::cos(radians(degrees))}; }
const vec3 n(0, 0, 1);
}  // namespace

TEST(Reflection, highlights_are_brightest_in_the_mirrored_direction) {
    for (const Lobe lobe : {Lobe::phong, Lobe::blinn}) {
        for (const double exponent : {1.0, 10.0, 1000.0}) {
            EXPECT_NEAR(highlight(lobe, n, at(-30), at(30), exponent), 1, 1e-12);  // 1000 roundings of a cosine near 1
            EXPECT_LT(highlight(lobe, n, at(-30), at(40), exponent), 1);
            // The lobes are alike both ways before the division by the cosine.
            EXPECT_NEAR(highlight(lobe, n, at(-30), at(10), exponent), highlight(lobe, n, at(10), at(-30), exponent),
                        1e-12);
        }
    }
}

// The brushing runs round the y axis, so across it the highlight is as wide as Phong's and along it not at all.
TEST(Reflection, brushed_highlight_runs_across_the_brushing) {
    const vec3 l = at(0), threads(1, 0, 0);
    for (const double degrees : {10.0, 40.0, 80.0}) {
        const vec3 across = std::cos(radians(degrees)) * n + std::sin(radians(degrees)) * vec3(0, 1, 0);
        EXPECT_NEAR(highlight(Lobe::brushed, n, l, across, 50), 1, 1e-12);
        const vec3 along = std::cos(radians(degrees)) * n + std::sin(radians(degrees)) * threads;
        EXPECT_NEAR(highlight(Lobe::brushed, n, l, along, 50), std::pow(std::cos(radians(degrees)), 50), 1e-12);
    }
    EXPECT_GT(highlight(Lobe::brushed, vec3(0, 1, 0), vec3(0, 1, 0), vec3(0, 1, 0), 50),
              0.99);  // where it has no middle
}

TEST(Reflection, extremes_are_finite) {
    for (const Lobe lobe : {Lobe::phong, Lobe::blinn, Lobe::brushed}) {
        for (const double exponent : {0.0, 1.0, 1000.0}) {
            for (const double l : {-180.0, -90.0, 0.0, 45.0, 90.0}) {
                for (const double v : {-90.0, 0.0, 90.0, 135.0, l + 180}) {
                    const double light = highlight(lobe, n, at(l), at(v), exponent);
                    EXPECT_TRUE(light >= 0 && light <= 1 + 1e-12)
                        << int(lobe) << " " << exponent << " " << l << " " << v;
                    if (std::abs(l) > 90) {
                        EXPECT_EQ(light, 0);
                    }
                }
            }
        }
    }
    EXPECT_EQ(highlight(Lobe::blinn, n, n, -n, 10), 0);  // no half vector
    EXPECT_EQ(reflectance(Lobe::phong, n, at(120), n, 10), HUGE_VAL);
}

TEST(Reflection, matching_exponent) {
    // The known rule, of highlights narrow enough: 4 cos.
    EXPECT_NEAR(matchingExponent(1000, 0) / 1000, 4, 0.04);
    EXPECT_NEAR(matchingExponent(1000, 60) / 1000, 2, 0.03);
    // A wide one is cut by the horizon, so the rule is off; its sum is Phong's all the same. By other directions: all of
    // the hemisphere, evenly in height and turn.
    const auto sum = [](Lobe lobe, double exponent, double angle) {
        double total = 0;
        for (int i = 0; i < 400; ++i) {
            for (int j = 0; j < 400; ++j) {
                const double z = (i + 0.5) / 400, turn = 2 * pi * (j + 0.5) / 400, r = std::sqrt(1 - z * z);
                total += highlight(lobe, n, at(-angle), vec3(r * std::cos(turn), r * std::sin(turn), z), exponent);
            }
        }
        return total;
    };
    for (const double angle : {0.0, 30.0, 60.0, 80.0}) {
        const double ratio = sum(Lobe::blinn, matchingExponent(5, angle), angle) / sum(Lobe::phong, 5, angle);
        EXPECT_NEAR(ratio, 1, 0.01) << angle;  // as its header says, and this sum's own error is a tenth of it
    }
    EXPECT_NE(refusal([] { (void)matchingExponent(0.5, 0); }).find("1 to 1000"), std::string::npos);
    EXPECT_NE(refusal([] { (void)matchingExponent(5, 81); }).find("0 to 80"), std::string::npos);
}
