#include "mv/motion/two_link.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mv/error.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

// An angle of up to pi as a double of degrees is off by 2.5e-16 rad, and the steps to it by as much again; two of them
// move the end by as many parts of the reach, and its sum is rounded: 16 roundings of 1.1e-16.
constexpr double rounding = 16 * 1.1e-16;

double miss(double l1, double l2, const vec2& target, const TwoLinkAngles& angles) {
    return glm::length((twoLinkEnd(l1, l2, angles) - target) / (l1 + l2));
}

TEST(TwoLink, TheEndOfTheAnglesIsTheTarget) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const double l1 = random.logarithmic(1e-3, 1e3), l2 = random.logarithmic(1e-3, 1e3);
        // Anywhere between the bounds, and as near to either as 1e-16 of the way.
        const double part = random.logarithmic(1e-17, 1), hole = std::abs(l1 - l2);
        const double distance = i % 2 == 0 ? hole + part * (l1 + l2 - hole) : l1 + l2 - part * (l1 + l2 - hole);
        const double direction = random.number(-pi, pi);
        const vec2 target(distance * std::cos(direction), distance * std::sin(direction));
        const TwoLinkAnswer answer = twoLinkAngles(l1, l2, target);
        for (const TwoLinkAngles& angles : answer.angles) {
            EXPECT_LT(miss(l1, l2, target, angles), rounding) << l1 << " " << l2 << " " << target.x << " " << target.y;
            EXPECT_LE(std::abs(angles.shoulder), 180);
            EXPECT_LE(std::abs(angles.elbow), 180);
        }
        EXPECT_EQ(answer.distance == 0, answer.solutions != TwoLinkSolutions::none);
    }
}

TEST(TwoLink, BothSolutionsMirrorEachOther) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const double l1 = random.number(0.5, 2), l2 = random.number(0.5, 2);
        const double distance = random.number(std::abs(l1 - l2) + 0.01, l1 + l2 - 0.01),
                     direction = random.number(-pi, pi);
        const TwoLinkAnswer answer =
            twoLinkAngles(l1, l2, {distance * std::cos(direction), distance * std::sin(direction)});
        ASSERT_EQ(answer.solutions, TwoLinkSolutions::two);
        EXPECT_GT(answer.angles[0].elbow, 0);
        EXPECT_EQ(answer.angles[1].elbow, -answer.angles[0].elbow);
        // The shoulders lie as far to the right of the way to the target as to the left of it. Differences of angles up
        // to 360.
        const double right = std::remainder(degrees(direction) - answer.angles[0].shoulder, 360);
        const double left = std::remainder(answer.angles[1].shoulder - degrees(direction), 360);
        EXPECT_NEAR(right, left, 5e-13);
        EXPECT_GT(right, 0);
    }
}

TEST(TwoLink, CountsItsSolutionsRightAtTheBorders) {
    const auto solutions = [](double l1, double l2, const vec2& target) {
        return twoLinkAngles(l1, l2, target).solutions;
    };
    using enum TwoLinkSolutions;
    const double least = 0x1p-52;
    // |target| = 5, exactly
    EXPECT_EQ(solutions(3, 2, {3, 4}), one);
    EXPECT_EQ(solutions(2, 3, {-4, 3}), one);
    EXPECT_EQ(solutions(9, 4, {3, -4}), one);  // folded
    EXPECT_EQ(solutions(4, 9, {-3, -4}), one);
    EXPECT_EQ(solutions(3, 2 - least, {3, 4}), none);
    EXPECT_EQ(solutions(3, 2 + 4 * least, {3, 4}), two);
    EXPECT_EQ(solutions(9, 4 - 4 * least, {3, -4}), none);
    EXPECT_EQ(solutions(9, 4 + 4 * least, {3, -4}), two);
    // 0.1 + 0.2 is more than 0.3 in doubles, by less than an ulp: the sum itself cannot say.
    EXPECT_EQ(solutions(0.1, 0.2, {0.3, 0}), two);
    EXPECT_EQ(solutions(1, 1, {0, 0}), infinitelyMany);
    EXPECT_EQ(solutions(1, 1 + least, {0, 0}), none);
    EXPECT_EQ(solutions(1, 1, {1e-300, 0}), two);
    EXPECT_EQ(solutions(1, 0, {0.6, 0.8}), infinitelyMany);
    EXPECT_EQ(solutions(0, 1, {0, -1}), infinitelyMany);
    EXPECT_EQ(solutions(1, 0, {0.5, 0}), none);
    EXPECT_EQ(solutions(0, 0, {0, 0}), infinitelyMany);
    EXPECT_EQ(solutions(0, 0, {1, 0}), none);
}

TEST(TwoLink, SaysHowFarATargetOutOfReachIsAndGoesAsNearAsItCan) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const double l1 = random.number(0.1, 2), l2 = random.number(0.1, 2), direction = random.number(-pi, pi);
        const bool isFar = i % 2 == 0;
        const double distance = isFar ? l1 + l2 + random.number(0, 2) : std::abs(l1 - l2) * random.number(0, 0.99);
        const vec2 target(distance * std::cos(direction), distance * std::sin(direction));
        const TwoLinkAnswer answer = twoLinkAngles(l1, l2, target);
        ASSERT_EQ(answer.solutions, TwoLinkSolutions::none);
        const double gap = isFar ? distance - (l1 + l2) : std::abs(l1 - l2) - distance;
        // The target's own roundings and those of the difference: some of numbers up to 6, of 4e-16 each. No point that
        // the arm reaches is nearer than the gap.
        EXPECT_NEAR(answer.distance, gap, 4e-15);
        EXPECT_NEAR(glm::length(twoLinkEnd(l1, l2, answer.angles[0]) - target), gap, 5e-15);
        EXPECT_NE(answer.reason.find(isFar ? "farther" : "nearer"), std::string_view::npos);
    }
    EXPECT_NEAR(twoLinkEnd(2, 1, twoLinkAngles(2, 1, {0, 0}).angles[0]).x, 1, 1e-15);
}

TEST(TwoLink, TheLecturesExample) {
    // Angles 60 and 250 degrees, the second of which is -110: the elbow bends clockwise.
    const vec2 end = twoLinkEnd(2, 1, {60, 250});
    EXPECT_NEAR(end.x, 1 + 0.6427876096865394, 5e-16);
    EXPECT_NEAR(end.y, 1.7320508075688772 - 0.766044443118978, 5e-16);
    const TwoLinkAnswer answer = twoLinkAngles(2, 1, end);
    EXPECT_NEAR(answer.angles[1].shoulder, 60, 1e-13);  // degrees: roundings of 250
    EXPECT_NEAR(answer.angles[1].elbow, -110, 1e-13);
}

// Square corners, by hand.
TEST(TwoLink, KnownAngles) {
    const TwoLinkAnswer answer = twoLinkAngles(3, 4, {5, 0});
    EXPECT_NEAR(answer.angles[0].elbow, 90, 3e-14);
    EXPECT_NEAR(answer.angles[0].shoulder, -degrees(std::atan2(4, 3)), 3e-14);
    const TwoLinkAnswer straight = twoLinkAngles(1, 2, {0, 3});
    EXPECT_EQ(straight.angles[0].shoulder, 90);
    EXPECT_EQ(straight.angles[0].elbow, 0);
    const TwoLinkAnswer folded = twoLinkAngles(1, 3, {0, 2});
    EXPECT_EQ(folded.angles[0].shoulder, -90);
    EXPECT_EQ(folded.angles[0].elbow, 180);
}

TEST(TwoLink, KeepsItsDigitsAtAnySize) {
    for (const double size : {1e-300, 1e-160, 1e-6, 1e6, 1e160, 1e299}) {
        const TwoLinkAnswer answer = twoLinkAngles(2 * size, size, {size, 1.5 * size});
        ASSERT_EQ(answer.solutions, TwoLinkSolutions::two) << size;
        for (const TwoLinkAngles& angles : answer.angles) {
            EXPECT_LT(miss(2 * size, size, {size, 1.5 * size}, angles), rounding) << size;
        }
    }
    // A link of 1 and one of 1e-20: the short one is beyond what a sum of both can tell.
    const TwoLinkAnswer answer = twoLinkAngles(1, 1e-20, {1, 0});
    EXPECT_EQ(answer.solutions, TwoLinkSolutions::two);
    EXPECT_NEAR(answer.angles[0].elbow, 90, 1e-13);
}

TEST(TwoLink, RefusesWhatIsNoArm) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(twoLinkAngles(-1, 1, {1, 0}), Error);
    EXPECT_THROW(twoLinkAngles(NAN, 1, {1, 0}), Error);
    EXPECT_THROW(twoLinkAngles(1, infinity, {1, 0}), Error);
    EXPECT_THROW(twoLinkAngles(1, 1, {NAN, 0}), Error);
    EXPECT_THROW(twoLinkAngles(1, 1, {0, infinity}), Error);
    EXPECT_THROW(twoLinkAngles(1, 1, {1e300, 1e300}), Error);
    EXPECT_THROW(twoLinkEnd(1, -1, {}), Error);
    EXPECT_THROW(twoLinkEnd(1, 1, {NAN, 0}), Error);
    EXPECT_THROW(twoLinkEnd(1, 1, {0, infinity}), Error);
    EXPECT_NEAR(twoLinkEnd(1, 1, {360e9, 90}).y, 1, 1e-15);
}

}  // namespace
