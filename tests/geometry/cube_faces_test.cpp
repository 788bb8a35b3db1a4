#include "mv/geometry/cube_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "mv/error.h"
#include "mv/math/projection.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 anyDirection(Random& random) { return {random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)}; }

}  // namespace

TEST(CubeFaces, a_direction_is_found_where_it_lies) {
    Random random(31);
    for (int i = 0; i < 2000; ++i) {
        const vec3 direction = anyDirection(random);
        const CubePlace place = cubePlace(direction);
        EXPECT_GE(std::min(place.at.x, place.at.y), 0);
        EXPECT_LE(std::max(place.at.x, place.at.y), 1);
        // The point of the cube there lies in that direction. Some roundings of numbers up to 1.
        EXPECT_LT(glm::distance(glm::normalize(cubeDirection(place)), glm::normalize(direction)), 1e-15);
        EXPECT_EQ(cubePlace(1e300 * direction).face, place.face);
        EXPECT_EQ(cubePlace(1e-300 * direction).face, place.face);
    }
}

// OpenGL 4.6, table 8.19, by hand for one direction of each face.
TEST(CubeFaces, the_table_is_that_of_the_specification) {
    const auto expectPlace = [](const vec3& direction, int face, double s, double t) {
        const CubePlace place = cubePlace(direction);
        EXPECT_EQ(place.face, face);
        EXPECT_EQ(place.at.x, s);
        EXPECT_EQ(place.at.y, t);
    };
    expectPlace({1, 0.5, 0.25}, 0, 0.375, 0.25);
    expectPlace({-1, 0.5, 0.25}, 1, 0.625, 0.25);
    expectPlace({0.5, 1, 0.25}, 2, 0.75, 0.625);
    expectPlace({0.5, -1, 0.25}, 3, 0.75, 0.375);
    expectPlace({0.5, 0.25, 1}, 4, 0.75, 0.375);
    expectPlace({0.5, 0.25, -1}, 5, 0.25, 0.375);
}

TEST(CubeFaces, a_camera_of_a_face_draws_where_it_is_found) {
    Random random(32);
    const mat4 clipFromView = perspective(90, 1, 0.1, 10);
    for (int i = 0; i < 1000; ++i) {
        const vec3 direction = anyDirection(random);
        const CubePlace place = cubePlace(direction);
        const vec4 clip = clipFromView * cubeFaceView(place.face) * vec4(3.0 * glm::normalize(direction), 1);
        EXPECT_GT(clip.w, 0);
        EXPECT_NEAR(0.5 + 0.5 * clip.x / clip.w, place.at.x, 1e-14);
        EXPECT_NEAR(0.5 + 0.5 * clip.y / clip.w, place.at.y, 1e-14);
    }
    for (int face = 0; face < cubeFaces; ++face) EXPECT_EQ(glm::determinant(mat3(cubeFaceView(face))), 1) << face;
}

TEST(CubeFaces, between_faces_it_is_the_first) {
    EXPECT_EQ(cubePlace({1, 1, 1}).face, 0);
    EXPECT_EQ(cubePlace({-1, -1, -1}).face, 1);
    EXPECT_EQ(cubePlace({0, 1, 1}).face, 2);
    EXPECT_EQ(cubePlace({0.5, -1, 1}).face, 3);
    // At an edge the places of both faces are the same point of the cube.
    EXPECT_EQ(cubeDirection({0, {0, 0.25}}), cubeDirection({4, {1, 0.25}}));
}

TEST(CubeFaces, what_is_no_direction_is_refused) {
    EXPECT_THROW(cubePlace(vec3(0)), Error);
    EXPECT_THROW(cubePlace({-0.0, 0.0, 0.0}), Error);
    EXPECT_THROW(cubePlace({std::nan(""), 1, 0}), Error);
    EXPECT_THROW(cubePlace({std::numeric_limits<double>::infinity(), 1, 0}), Error);
    EXPECT_THROW(cubeDirection({6, vec2(0.5)}), Error);
    EXPECT_THROW(cubeDirection({0, {std::nan(""), 0.5}}), Error);
    EXPECT_THROW(cubeFaceView(-1), Error);
}
