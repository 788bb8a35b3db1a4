#include "path/pose_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

using namespace mv;

namespace {

TEST(PoseSphere, MeasuresATurn) {
    // 120 degrees to the left about y, twice as fast at the end as at the beginning
    const Turning turning = turningOf([](double t) { return quatFromYawPitchRoll(120 * (2 * t + t * t) / 3, 0, 0); });
    EXPECT_NEAR(turning.whole, 120, 1e-10);
    // Means over 1/180 of what is 80 and 160 at the ends, and has the slope 80
    EXPECT_NEAR(turning.slowest, 80 + 80 / 360.0, 1e-9);
    EXPECT_NEAR(turning.fastest, 160 - 80 / 360.0, 1e-9);
    ASSERT_EQ(turning.nose.size(), 181U);
    EXPECT_LT(glm::length(turning.nose.front() - vec3(0, 0, -1)), 1e-14);
    EXPECT_LT(glm::length(turning.nose.back() - vec3(-std::sin(radians(120)), 0, 0.5)), 1e-14);
    for (const vec3& roof : turning.roof) EXPECT_LT(glm::length(roof - vec3(0, 1, 0)), 1e-14);
}

}  // namespace
