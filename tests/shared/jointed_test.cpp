#include "robot-arm/jointed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mv/error.h"
#include "mv/motion/two_link.h"

using namespace mv;

namespace {

// As many parts as joints, each with a name, and with that of an angle where the joint turns.
void expectWhole(const Jointed& thing) {
    ASSERT_EQ(thing.parts.size(), thing.tree.joints().size());
    for (std::size_t i = 0; i < thing.parts.size(); ++i) {
        EXPECT_FALSE(thing.parts[i].name.empty());
        EXPECT_EQ(thing.parts[i].angle.empty(), thing.tree.joints()[i].kind == JointKind::fixed) << i;
    }
    thing.tree.requireEnd(thing.end);
}

std::vector<vec3> stickAt(const Jointed& thing, const std::vector<double>& degrees) {
    return stickOf(thing, thing.tree.worldFromJoints(degrees));
}

}  // namespace

TEST(Jointed, two_links_end_where_the_formula_says) {
    const Jointed thing = twoLinks(1.25, 0.5);
    expectWhole(thing);
    const auto stick = stickAt(thing, {60, 250});
    ASSERT_EQ(stick.size(), 3U);
    // Products of sines and lengths up to 1.75, some roundings each
    EXPECT_LT(glm::distance(vec2(stick[2]), twoLinkEnd(1.25, 0.5, {60, 250})), 2e-15);
    EXPECT_LT(glm::distance(vec2(stick[1]), twoLinkEnd(1.25, 0, {60, 0})), 2e-15);
}

TEST(Jointed, the_arm_reaches_as_far_as_its_links_together_in_any_direction) {
    for (const bool hasLimits : {false, true}) {
        const Jointed thing = arm(1.2, 0.8, hasLimits);
        expectWhole(thing);
        EXPECT_EQ(std::isfinite(thing.tree.joints()[2].least), hasLimits);
        for (const double turn : {-120.0, 0.0, 70.0}) {
            for (const double shoulder : {0.0, 35.0, 150.0}) {
                const auto stick = stickAt(thing, {turn, shoulder, 0, 0});
                ASSERT_EQ(stick.size(), 4U) << "the turret has no length";
                EXPECT_EQ(stick[0], vec3(0));
                EXPECT_NEAR(glm::length(stick[3]), 2.4, 1e-15 * 4);
                EXPECT_NEAR(stick[3].y, 2.4 * std::sin(radians(shoulder)), 1e-15 * 4);
            }
        }
    }
}

TEST(Jointed, starts_of_the_arm_are_within_its_limits_and_differ) {
    const Jointed thing = arm(1.2, 0.8, true);
    std::vector<double> least(4, 1), most(4, 0);
    for (int k = 0; k < 60; ++k) {
        const auto start = armStart(k);
        ASSERT_EQ(start.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            const Joint& joint = thing.tree.joints()[i];
            const double part = (start[i] - joint.least) / (joint.most - joint.least);
            least[i] = std::min(least[i], part);
            most[i] = std::max(most[i], part);
        }
    }
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_GE(least[i], 0);
        EXPECT_LT(least[i], 0.1) << "60 numbers, evenly, leave gaps of about 1/60";
        EXPECT_GT(most[i], 0.9);
        EXPECT_LE(most[i], 1);
    }
    EXPECT_THROW(armStart(-1), Error);
}

TEST(Jointed, legs_hang_on_one_body_and_move_alone) {
    const Jointed thing = legs(1.2, 0.8, {3, 1.9});
    expectWhole(thing);
    const auto rest = thing.tree.worldFromJoints(std::vector<double>{0, -90, 0, -90, 0});
    const auto moved = thing.tree.worldFromJoints(std::vector<double>{0, -90, 0, -60, -20});
    EXPECT_EQ(rest[0], moved[0]);
    EXPECT_EQ(rest[2], moved[2]) << "the near leg";
    EXPECT_NE(rest[4], moved[4]) << "the far leg";
    const auto stick = stickOf(thing, rest);
    ASSERT_EQ(stick.size(), 4U) << "body, hip, knee, foot";
    EXPECT_LT(glm::distance(stick[3], vec3(3, 1.9 - 2, legSide)), 4e-16 * 4);
}
