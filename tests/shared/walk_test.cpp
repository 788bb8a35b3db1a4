#include "robot-arm/walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "mv/motion/two_link.h"
#include "robot-arm/jointed.h"

using namespace mv;

namespace {

constexpr Walk walk{.upper = 1.2, .lower = 0.8, .poses = 8};

// The places of the near foot and of the far one.
std::vector<vec2> feetAt(double cycles) {
    Jointed thing = legs(walk.upper, walk.lower, walk.hip(cycles));
    const auto degrees = walk.played(cycles);
    const vec3 near = thing.tree.endPosition(degrees, thing.end);
    thing.end.joint = 4;
    return {vec2(near), vec2(thing.tree.endPosition(degrees, thing.end))};
}

}  // namespace

TEST(Walk, at_its_poses_the_feet_are_where_they_have_to_be_and_between_them_not_far) {
    for (int i = -16; i < 160; ++i) {
        const double pose = i / 8.0, between = (i + 0.5) / 8.0;
        for (const int side : {0, 1}) {
            const auto index = static_cast<std::size_t>(side);
            // Up to 36 m from the origin, some roundings of 2^-48
            EXPECT_LT(glm::distance(feetAt(pose)[index], walk.foot(side, pose).position), 5e-14) << i;
            const double off = glm::distance(feetAt(between)[index], walk.foot(side, between).position);
            EXPECT_GT(off, 1e-5) << i;
            EXPECT_LT(off, 0.3) << i << ", an eighth of a cycle is 0.225 m";
        }
    }
}

TEST(Walk, knees_bend_forward_and_feet_take_turns) {
    for (int i = 0; i < 100; ++i) {
        const auto degrees = walk.played(i / 100.0);
        EXPECT_EQ(degrees.size(), 5U);
        EXPECT_LT(degrees[2], 0);
        EXPECT_LT(degrees[4], 0);
        EXPECT_TRUE(walk.foot(0, i / 100.0).stands || walk.foot(1, i / 100.0).stands);
    }
}
