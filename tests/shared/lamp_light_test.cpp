#include "lights/lamp_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mv/error.h"
#include "mv/geometry/shapes.h"
#include "mv/math/projection.h"
#include "shared/lamp_reach.h"

using namespace mv;

TEST(LampLight, FallsAndNeverRises) {
    const Falloff falloff{.constant = 0.5, .linear = 0.3, .quadratic = 2, .size = 0.1};
    double last = falloff.at(0);
    EXPECT_EQ(falloff.at(0), falloff.at(0.1)) << "nearer than the lamp's surface there is no more";
    for (double d = 0; d < 10; d += 0.01) {
        EXPECT_LE(falloff.at(d), last);
        last = falloff.at(d);
    }
    EXPECT_DOUBLE_EQ((Falloff{}.at(2)), 0.25);
    EXPECT_THROW((void)(Falloff{.quadratic = 0}.at(1)), Error);
    EXPECT_THROW((void)falloff.at(-1), Error);
    EXPECT_THROW((void)falloff.at(NAN), Error);
}

TEST(LampLight, ReachIsWhereTheThresholdIs) {
    for (const Falloff& falloff :
         {Falloff{}, Falloff{0, 1, 0, 0.01}, Falloff{1, 1, 1, 0.01}, Falloff{0, 2, 1e-9, 0.01}}) {
        const double reach = falloff.reach(3, 0.01);
        // A rounding of some places of 1
        EXPECT_NEAR(3 * falloff.at(reach) / 0.01, 1, 1e-14);
    }
    EXPECT_EQ(Falloff{}.reach(3, 0), HUGE_VAL);
    EXPECT_EQ((Falloff{1, 0, 0, 0.01}.reach(3, 0.01)), HUGE_VAL);
    EXPECT_EQ((Falloff{1, 0, 0, 0.01}.reach(0.001, 0.01)), 0);
}

TEST(LampLight, SpotEdge) {
    EXPECT_EQ(spotEdge(1, 0.9, 0.7), 1);
    EXPECT_EQ(spotEdge(0.7, 0.9, 0.7), 0);
    EXPECT_DOUBLE_EQ(spotEdge(0.8, 0.9, 0.7), 0.5);
    EXPECT_EQ(spotEdge(0.8, 0.8, 0.8), 1);
    EXPECT_THROW((void)spotEdge(0.8, 0.7, 0.9), Error);
    EXPECT_THROW((void)spotEdge(NAN, 0.9, 0.7), Error);
}

TEST(LampReach, ABallThatTouchesNothingReachesNothing) {
    Scene scene;
    scene.objects = {{"box", box({-1, -1, -1}, {1, 1, 1})}};
    const mat4 clipFromWorld = ortho(-2, 2, -2, 2, -10, 10);
    EXPECT_TRUE(canReach(scene, clipFromWorld, {0, 1.5, 0}, 0.6));
    EXPECT_FALSE(canReach(scene, clipFromWorld, {0, 1.5, 0}, 0.4)) << "in view, and short of the box";
    EXPECT_FALSE(canReach(scene, clipFromWorld, {0, 4, 0}, 1.9)) << "outside of the view";
    EXPECT_TRUE(canReach(scene, clipFromWorld, {0, 4, 0}, 3.1));
}
