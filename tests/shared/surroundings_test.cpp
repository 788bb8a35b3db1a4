#include "environment/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "environment/shiny_sphere.h"
#include "mv/error.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 anyDirection(Random& random) {
    return glm::normalize(vec3(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)));
}

}  // namespace

TEST(Room, walls_are_where_rays_leave) {
    const Room room{4, 30};
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Ray ray{{random.number(-3, 3), random.number(-2, 2), random.number(-3, 3)}, anyDirection(random)};
        const vec3 wall = room.wallAlong(ray), part = glm::abs(wall) / room.halfSize();
        // On a wall and beyond none, to some roundings of a way of 10 units.
        EXPECT_NEAR(std::max({part.x, part.y, part.z}), 1, 1e-14);
        EXPECT_LT(glm::length(glm::cross(wall - ray.origin, ray.direction)), 1e-13);
        EXPECT_GT(glm::dot(wall - ray.origin, ray.direction), 0);
    }
    EXPECT_EQ(room.wallAlong({vec3(1, 1, 1), vec3(0, 0, -1)}), vec3(1, 1, -4));  // along two walls
}

TEST(Room, a_larger_one_looks_the_same_from_the_middle) {
    Random random(6);
    for (int i = 0; i < 500; ++i) {
        const vec3 way = anyDirection(random);
        const vec3 small = Room{2, 77}.seenAlong({vec3(0), way}), large = Room{1024, 77}.seenAlong({vec3(0), way});
        EXPECT_LT(glm::distance(small, large), 1e-12);
    }
}

TEST(Room, balls_lie_on_the_floor_beside_the_body) {
    for (const double size : {2.0, 50.0}) {
        for (int round = 0; round < 360; round += 10) {
            const Room room{size, double(round)};
            const auto places = room.ballPlaces();
            for (std::size_t i = 0; i < places.size(); ++i) {
                EXPECT_NEAR(places.at(i).y - room.ballRadius(), -room.halfSize().y, 1e-13 * size);
                EXPECT_GT(glm::length(places.at(i)), 1 + room.ballRadius());
                EXPECT_LT(std::max(std::abs(places.at(i).x), std::abs(places.at(i).z)) + room.ballRadius(), size);
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_GT(glm::distance(places.at(i), places.at(j)), 2 * room.ballRadius());
            }
        }
    }
}

TEST(Room, a_ball_hides_the_wall_behind_it) {
    const Room room{4, 0};
    const vec3 ball = room.ballPlaces().front();
    const vec3 light = room.seenAlong({vec3(0), glm::normalize(ball)});
    // Red, and darker below than above: seen from the middle and above, at a height above its own middle.
    EXPECT_GT(light.x, 3 * light.y);
    EXPECT_GT(light.x, 0.85 * 0.6);
    // Not where it is behind the ray's beginning.
    EXPECT_LT(room.seenAlong({vec3(0), -glm::normalize(ball)}).x, 3 * light.y + 1);
}

TEST(Room, balls_are_in_view_or_hidden_where_their_points_are) {
    const Room room{4, 180};  // the first ball is behind the middle, seen from +z
    const mat4 clipFromView = perspective(60, 1, 0.1, 100);
    const vec3 behind = room.ballPlaces().front(), eye = -3.0 * glm::normalize(behind);
    EXPECT_TRUE(room.isBallHidden(0, eye));
    EXPECT_FALSE(room.isBallHidden(0, 3.0 * glm::normalize(behind)));  // it is before the sphere
    EXPECT_FALSE(room.isBallHidden(0, vec3(4, 0, 0)));                 // beside it
    EXPECT_TRUE(room.isBallInView(0, clipFromView * lookAtAnyRoll(eye, behind)));
    EXPECT_FALSE(room.isBallInView(0, clipFromView * lookAtAnyRoll(eye, 2.0 * eye)));
}

TEST(Sky, is_light_and_has_no_seams) {
    const auto faces = skyCube(8);
    for (const FloatPicture& face : faces) {
        for (const float value : face.values) {
            EXPECT_GE(value, 0.0F);
            EXPECT_LE(value, 1.0F);
        }
    }
    // The light is a function of the direction alone: on both sides of an edge it is the same, and its length does not matter.
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0;
        EXPECT_EQ(skyAlong(cubeDirection({0, {0, t}})), skyAlong(cubeDirection({4, {1, t}})));
        EXPECT_LT(glm::distance(skyAlong(vec3(0.3, t - 0.5, 1)), skyAlong(7.0 * vec3(0.3, t - 0.5, 1))), 1e-12);
    }
    // Brighter above than below, on the whole.
    EXPECT_GT(skyAlong({0, 1, 0}).z, skyAlong({0, -1, 0}).z);
}

TEST(ShinySphere, a_mirror_shows_what_a_mirrored_ray_sees) {
    const ShinySphere sphere{.room = {5, 40}};
    const auto light = sphere.seenAlong({{0, 0, 4}, {0, 0, -1}});
    ASSERT_TRUE(light);
    EXPECT_EQ(*light, sphere.room.seenAlong({{0, 0, 1}, {0, 0, 1}}));
    EXPECT_FALSE(sphere.seenAlong({{0, 2, 4}, {0, 0, -1}}));
    EXPECT_FALSE(sphere.seenAlong({{0, 0, 4}, {0, 0, 1}}));
}

TEST(ShinySphere, glass_divides_light_and_loses_none) {
    // Nothing of the glass is to be seen where all around is alike: with all its inner reflections it sends out what it gets.
    // Walls of tiles are not; but along one axis, head on, light comes from two places only.
    ShinySphere sphere{.room = {5, 40}, .coating = {.kind = Coating::Kind::glass}, .innerReflections = 100};
    const Ray ray{{0, 0, 4}, {0, 0, -1}};
    const vec3 front = sphere.room.seenAlong({{0, 0, 1}, {0, 0, 1}}),
               back = sphere.room.seenAlong({{0, 0, -1}, {0, 0, -1}});
    // By hand: R + T R T (1 + R^2 + ...) of the front, T T (1 + R^2 + ...) of the back, with R = 0.04.
    const double r = 0.04, t = 0.96, again = 1 / (1 - r * r);
    const auto light = sphere.seenAlong(ray);
    ASSERT_TRUE(light);
    // The part that is left out is less than 1e-6 of the light.
    EXPECT_LT(glm::distance(*light, (r + t * t * r * again) * front + t * t * again * back), 1e-6);
    EXPECT_NEAR(r + t * t * r * again + t * t * again, 1, 1e-15);
    sphere.coating.index = 1;
    EXPECT_LT(glm::distance(*sphere.seenAlong(ray), back), 1e-15);
}
