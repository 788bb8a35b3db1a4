#include "shared/car.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "mv/geometry/check.h"

using namespace mv;

namespace {

TEST(Car, IsAsLargeAsItSays) {
    vec3 low(1e9), high(-1e9);
    for (const mat4& carFromCube : carFromCubes()) {
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.5, 0.5}) {
                for (const double z : {-0.5, 0.5}) {
                    const vec3 corner(carFromCube * vec4(x, y, z, 1));
                    low = glm::min(low, corner);
                    high = glm::max(high, corner);
                }
            }
        }
    }
    EXPECT_EQ(low, vec3(-5, -1.5, 0));
    EXPECT_EQ(high, vec3(5, 1.5, 4));
}

TEST(Car, LooksAlongMinusZWithYUp) {
    const MeshData mesh = carLookingAlongMinusZ(0.5);
    validate(mesh);
    fvec3 low(1e9F), high(-1e9F);
    for (const fvec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    // Half as large; some roundings to float
    EXPECT_LT(glm::length(low - fvec3(-0.75, 0, -2.5)), 1e-6);
    EXPECT_LT(glm::length(high - fvec3(0.75, 2, 2.5)), 1e-6);
    // The cabin, which is above half the height, is behind the middle: towards +z.
    double front = 0;
    for (const fvec3& position : mesh.positions) {
        if (position.y > 1.5F) front = std::min(front, double(position.z));
    }
    EXPECT_NEAR(front, -0.5 * (2 - 0.8), 1e-6);
}

}  // namespace
