#include "mv/geometry/lamp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "mv/error.h"

using namespace mv;

namespace {

const SceneLight level{.position = {1, 4, -2, 1}, .halfU = {0.4, 0, 0.3}, .halfV = {-0.3, 0, 0.4}};

template <class Function>
std::string refusal(Function function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was refused";
}

}  // namespace

TEST(Lamp, points_lie_on_it_one_in_each_cell) {
    std::vector<int> cells(49, 0);
    for (const vec3& p : lampPoints(level, 7, 3)) {
        const vec3 offset = p - vec3(1, 4, -2);
        EXPECT_EQ(offset.y, 0);
        // The half sides are perpendicular and 0.5 long.
        const double s = glm::dot(offset, level.halfU) / 0.25, t = glm::dot(offset, level.halfV) / 0.25;
        ASSERT_LT(std::max(std::abs(s), std::abs(t)), 1);
        const int column = int((s + 1) * 3.5), row = int((t + 1) * 3.5), cell = column + 7 * row;
        ++cells[static_cast<std::size_t>(cell)];
    }
    EXPECT_EQ(std::count(cells.begin(), cells.end(), 1), 49);
    for (const vec3& p : lampPoints({.position = {2, 6, 4, 2}}, 3, 1)) EXPECT_EQ(p, vec3(1, 3, 2));
}

// The definition: the farthest and the nearest shadow that the lamp's corners throw of the edge, along `outwards`.
TEST(Lamp, penumbra_lies_between_the_shadows_of_the_corners) {
    const vec3 edge(0.3, 1.5, 0.2);
    for (const double angle : {0.0, 0.5, 2.0, 4.0}) {
        const vec3 outwards(std::cos(angle), 0, std::sin(angle));
        double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
        for (const vec2& corner : {vec2(-1, -1), vec2(-1, 1), vec2(1, -1), vec2(1, 1)}) {
            const vec3 light = vec3(level.position) + corner.x * level.halfU + corner.y * level.halfV;
            const vec3 shadow = light + (edge - light) * (light.y / (light.y - edge.y));  // on the ray, where y = 0
            nearest = std::min(nearest, glm::dot(shadow, outwards));
            farthest = std::max(farthest, glm::dot(shadow, outwards));
        }
        const Penumbra penumbra = penumbraOf(level, edge, outwards);
        EXPECT_NEAR(penumbra.width, farthest - nearest, 1e-14);  // a few roundings of numbers up to 4
        EXPECT_NEAR(glm::dot(penumbra.middle, outwards), (nearest + farthest) / 2, 1e-14);
        EXPECT_NEAR(penumbra.middle.y, 0, 1e-15);
    }
    // The lecture's numbers: a lamp 1 wide 3 high, an edge at 1: half as wide as the lamp; and at the floor none.
    const SceneLight lamp{.position = {0, 3, 0, 1}, .halfU = {0.5, 0, 0}, .halfV = {0, 0, 0.5}};
    EXPECT_DOUBLE_EQ(penumbraOf(lamp, {0, 1, 0}, {1, 0, 0}).width, 0.5);
    EXPECT_EQ(penumbraOf(lamp, {0, 0, 0}, {1, 0, 0}).width, 0);
}

TEST(Lamp, refusals) {
    const SceneLight far{.position = {0, 1, 0, 0}};
    SceneLight leaning = level;
    leaning.halfV.y = 0.1;
    const vec3 x(1, 0, 0);
    EXPECT_EQ(refusal([&] { lampPoints(far, 2, 1); }), "lampPoints: the lamp must be near (w > 0), (0, 1, 0, 0)");
    EXPECT_EQ(refusal([&] {
                  penumbraOf(level, {0, 4, 0}, x);
              }),
              "penumbraOf: the edge must be above the floor and below the lamp, (0, 4, 0)");
    EXPECT_EQ(refusal([&] {
                  penumbraOf(level, {0, -1, 0}, x);
              }),
              "penumbraOf: the edge must be above the floor and below the lamp, (0, -1, 0)");
    EXPECT_EQ(refusal([&] {
                  penumbraOf(leaning, {0, 1, 0}, x);
              }),
              "penumbraOf: the lamp's half side must be level (y = 0), (-0.3, 0.1, 0.4)");
    EXPECT_EQ(refusal([&] {
                  penumbraOf(level, {0, 1, 0}, {2, 0, 0});
              }),
              "penumbraOf: the way outwards must have length 1, (2, 0, 0)");
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal([&] {
                  penumbraOf(level, {0, notANumber, 0}, x);
              }),
              "penumbraOf: the edge must be finite, (0, nan, 0)");
}
