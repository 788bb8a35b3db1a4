#include "mv/motion/gait.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "motion/arms.h"
#include "mv/error.h"
#include "mv/motion/inverse_kinematics.h"
#include "mv/motion/two_link.h"

using namespace mv;
using namespace mv::test;

namespace {

const Gait walk{.stride = 0.8, .lift = 0.15, .stance = 0.6, .phase = 0.25};

TEST(Gait, StandsStillToTheBitAndThenGoesOneStride) {
    for (const double first : {-3.25, -0.25, 0.75, 100.75}) {  // the phase makes the cycle begin there
        const FootTarget there = footTarget(walk, first);
        for (int i = 0; i < 60; ++i) {
            const FootTarget foot = footTarget(walk, first + i / 100.0);
            EXPECT_TRUE(foot.stands) << i;
            EXPECT_EQ(foot.position, there.position) << i;
        }
        EXPECT_EQ(there.position.y, 0);
        // Products of numbers up to 100.
        EXPECT_NEAR(footTarget(walk, first + 1).position.x - there.position.x, walk.stride, 3e-14);
        // The body is over it in the middle of the stance.
        EXPECT_NEAR(there.position.x, walk.stride * (first + 0.3), 3e-14);
    }
}

TEST(Gait, SwingsForwardsWithoutADragOrABump) {
    const double begin = -0.25 + 0.6, end = 0.75, size = 1e-4;
    const auto at = [](double cycles) { return footTarget(walk, cycles).position; };
    for (double cycles = begin + size; cycles < end - size; cycles += size) {
        EXPECT_FALSE(footTarget(walk, cycles).stands);
        EXPECT_GT(at(cycles).x, at(cycles - size).x);
        EXPECT_GT(at(cycles).y, 0);
    }
    EXPECT_NEAR(at((begin + end) / 2).y, walk.lift, 1e-15);
    // Near its ends a part s of the swing moves the foot by 10 s^3 strides and lifts it by 64 s^3: so no velocity and
    // no acceleration there.
    const double s = size / 0.4;
    for (const double cycles : {begin + size, end - size}) {
        const vec2 moved = at(cycles) - at(cycles < 0.5 ? begin - size : end + size);
        EXPECT_LE(std::abs(moved.x), 10 * s * s * s * walk.stride + 1e-15);
        EXPECT_LE(moved.y, 64 * s * s * s * walk.lift + 1e-15);
    }
}

TEST(Gait, TheOtherFootIsHalfACycleApart) {
    Gait left = walk, right = walk;
    right.phase += 0.5;
    for (double cycles = 0; cycles < 3; cycles += 0.01) {
        EXPECT_TRUE(footTarget(left, cycles).stands || footTarget(right, cycles).stands);  // one is on the floor
        const vec2 later = footTarget(left, cycles + 0.5).position - vec2(walk.stride / 2, 0);
        EXPECT_NEAR(footTarget(right, cycles).position.x, later.x, 1e-14);
        EXPECT_NEAR(footTarget(right, cycles).position.y, later.y, 1e-14);
    }
}

// The lecture asks: what can forward kinematics not do? A leg of 0.5 and 0.5 whose hip is 0.9 high, hip angle from
// -90.
class WalkingLeg : public testing::Test {
  protected:
    static constexpr double high = 0.9;
    const Gait gait{.stride = 0.8, .lift = 0.15, .stance = 0.6};

    vec2 hip(double cycles) const { return {gait.stride * cycles, high}; }
    TwoLinkAngles solved(double cycles) const {
        // The knee bends backwards: the shin turns clockwise.
        return twoLinkAngles(0.5, 0.5, footTarget(gait, cycles).position - hip(cycles)).angles[1];
    }
    // The angles of the two poses beside, of so many in a cycle, interpolated.
    TwoLinkAngles interpolated(double cycles, int keys) const {
        const double key = std::floor(cycles * keys), part = cycles * keys - key;
        const TwoLinkAngles a = solved(key / keys), b = solved((key + 1) / keys);
        return {a.shoulder + part * (b.shoulder - a.shoulder), a.elbow + part * (b.elbow - a.elbow)};
    }
    // How far the foot gets from where it stands, over one stance.
    template <typename AnglesAt>
    double slide(AnglesAt anglesAt) const {
        double most = 0;
        for (int i = 0; i < 600; ++i) {
            const double cycles = i / 1000.0;
            const vec2 foot = hip(cycles) + twoLinkEnd(0.5, 0.5, anglesAt(cycles));
            most = std::max(most, glm::length(foot - footTarget(gait, cycles).position));
        }
        return most;
    }
};

TEST_F(WalkingLeg, StandsUnderInverseKinematics) {
    EXPECT_LT(slide([&](double cycles) { return solved(cycles); }), 2e-15);  // TwoLink's rounding, of a reach of 1
}

TEST_F(WalkingLeg, StandsUnderTheIterationToItsTolerance) {
    const Arm leg = planeArm({0.5, 0.5});
    std::vector<double> angles{solved(0).shoulder, solved(0).elbow};
    double most = 0;
    int iterations = 0;
    for (int i = 0; i < 600; ++i) {
        const double cycles = i / 1000.0;
        const vec2 foot = footTarget(gait, cycles).position - hip(cycles);
        const IkResult result = solveInverseKinematics(leg.tree, leg.end, vec3(foot, 0), angles);
        ASSERT_EQ(result.end, IkEnd::reached) << cycles;
        angles = result.degrees;
        most = std::max(most, result.distance);
        iterations = std::max(iterations, static_cast<int>(result.history.size()) - 1);
    }
    EXPECT_LE(most, 1e-9);
    EXPECT_LE(iterations, 4) << "from the last picture's angles it is a few steps";
}

TEST_F(WalkingLeg, SlidesWhereItsAnglesAreInterpolated) {
    const double of10 = slide([&](double cycles) { return interpolated(cycles, 10); });
    const double of20 = slide([&](double cycles) { return interpolated(cycles, 20); });
    RecordProperty("slide10", std::to_string(of10));
    RecordProperty("slide20", std::to_string(of20));
    // A millimetre and more on a leg of a metre; an error of order two, so twice the keys leave a quarter.
    EXPECT_GT(of10, 1e-3);
    EXPECT_NEAR(of10 / of20, 4, 0.5);
}

TEST(Gait, RefusesWhatIsNoGait) {
    for (const double stance : {0.0, 1.0, -0.5, 2.0, double{NAN}})
        EXPECT_THROW(footTarget({.stance = stance}, 0), Error);
    EXPECT_THROW(footTarget({.stride = NAN}, 0), Error);
    EXPECT_THROW(footTarget({.lift = 1e101}, 0), Error);
    EXPECT_THROW(footTarget({.phase = 1e13}, 0), Error);
    EXPECT_THROW(footTarget({}, NAN), Error);
    EXPECT_THROW(footTarget({}, std::numeric_limits<double>::infinity()), Error);
    EXPECT_THROW(footTarget({}, -1e13), Error);
    EXPECT_TRUE(footTarget({}, 1e12).stands);
    EXPECT_LT(footTarget({.stride = -1}, 2.8).position.x, footTarget({.stride = -1}, 2.7).position.x);
}

}  // namespace
