#include "mv/geometry/light_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "mv/error.h"
#include "mv/geometry/shapes.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

// Products of a few matrices with elements up to 100, in double.
constexpr double rounding = 1e-12;

std::vector<vec3> boxCorners(const vec3& low, const vec3& high) {
    std::vector<vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    return corners;
}

struct Range {
    vec3 low{1e300}, high{-1e300};
};

Range onMap(const LightView& view, const std::vector<vec3>& points) {
    Range range;
    for (const vec3& p : points) {
        const vec4 map = view.mapFromWorld() * vec4(p, 1);
        EXPECT_GT(map.w, 0);
        range.low = glm::min(range.low, vec3(map) / map.w);
        range.high = glm::max(range.high, vec3(map) / map.w);
    }
    return range;
}

std::string refusal(const vec4& light, const std::vector<vec3>& points, double margin = 0.02) {
    try {
        fitLightView(light, points, margin);
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was refused";
}

const std::vector<vec3> corners = boxCorners({-1, 0, -2}, {1, 2, 3});

TEST(LightView, PointsFillTheWindowUpToTheMargin) {
    for (const vec4& light : {vec4(4, 7, 2, 1), vec4(8, 14, 4, 2), vec4(0, 9, 0, 1), vec4(-30, 0.5, 0, 1),
                              vec4(1, 2, 3, 0), vec4(0, 1e-3, 0, 0), vec4(1, 1e-7, 0, 0)}) {
        for (const double margin : {0.0, 0.02, 0.2}) {
            const Range range = onMap(fitLightView(light, corners, margin), corners);
            const double inside = margin / (1 + 2 * margin);  // of the window, which has the margins too
            for (int axis = 0; axis < 2; ++axis) {
                EXPECT_NEAR(range.low[axis], inside, rounding);
                EXPECT_NEAR(range.high[axis], 1 - inside, rounding);
            }
            EXPECT_GE(range.low.z, -rounding);
            EXPECT_LE(range.high.z, 1 + rounding);
        }
    }
}

TEST(LightView, IsSeenFromTheLight) {
    const LightView view = fitLightView({4, 7, 2, 1}, corners);
    const vec4 eye = view.viewFromWorld * vec4(4, 7, 2, 1);
    EXPECT_LT(glm::length(vec3(eye)), rounding);
    // A point that lies behind another one on a ray from the light has its place on the map, and is farther.
    for (const vec3& p : corners) {
        const vec3 behind = vec3(4, 7, 2) + 1.1 * (p - vec3(4, 7, 2));
        const vec4 a = view.mapFromWorld() * vec4(p, 1), b = view.mapFromWorld() * vec4(behind, 1);
        EXPECT_NEAR(a.x / a.w, b.x / b.w, rounding);
        EXPECT_NEAR(a.y / a.w, b.y / b.w, rounding);
        EXPECT_LT(a.z / a.w, b.z / b.w);
    }
}

TEST(LightView, FromInfinityDepthIsLinearAlongTheDirection) {
    const vec3 towards = glm::normalize(vec3(1, 2, 3));
    const LightView view = fitLightView(vec4(5.0 * towards, 0), corners, 0);
    EXPECT_TRUE(view.atInfinity);
    const vec4 p = view.mapFromWorld() * vec4(0.3, 0.4, 0.5, 1);
    const vec4 q = view.mapFromWorld() * vec4(vec3(0.3, 0.4, 0.5) - 0.25 * towards, 1);
    EXPECT_NEAR(p.x, q.x, rounding);
    EXPECT_NEAR(p.y, q.y, rounding);
    EXPECT_NEAR(q.z - p.z, 0.25 / (view.bounds.far - view.bounds.near), rounding);
}

TEST(LightView, BoundsAreThoseOfTheProjection) {
    const LightView point = fitLightView({4, 7, 2, 1}, corners);
    EXPECT_EQ(point.clipFromView, frustum(point.bounds));
    EXPECT_FALSE(point.atInfinity);
    EXPECT_GT(point.bounds.near, 0);
    const auto [left, right, bottom, top, near, far] = fitLightView({4, 7, 2, 0}, corners).bounds;
    EXPECT_EQ(fitLightView({4, 7, 2, 0}, corners).clipFromView, ortho(left, right, bottom, top, near, far));
}

// With the gaze given, depth is the distance along it: a lamp's plane and the floor under it are each of one depth.
TEST(LightView, GivenGazeIsKept) {
    const LightView view = fitLightView(vec3(4, 7, 2), vec3(0, -2, 0), vec3(0, 0, 1), corners);
    const Range range = onMap(view, corners);
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(range.low[axis], 0.02 / 1.04, rounding);
        EXPECT_NEAR(range.high[axis], 1.02 / 1.04, rounding);
    }
    for (const vec3& p : {vec3(-9, 1, 3), vec3(0, 1, 0), vec3(5, 1, -7)}) {
        EXPECT_NEAR((view.mapFromWorld() * vec4(p, 1)).w, 6, rounding);  // 7 - 1 below the light
    }
    EXPECT_EQ(view.clipFromView, frustum(view.bounds));
    EXPECT_THROW(fitLightView(vec3(4, 7, 2), vec3(0, -1, 0), vec3(0, 1, 0), corners), Error);
    EXPECT_THROW(fitLightView(vec3(4, 2.1, 2), vec3(0, -1, 0), vec3(0, 0, 1), corners), Error);  // 88 degrees off
    EXPECT_THROW(fitLightView(vec3(4, 7, 2), vec3(0, -1, 0), vec3(0, 0, 1), corners, 0.5), Error);
}

// A level square under a light straight above it has no depth, a line has no width: both make a map.
TEST(LightView, FlatThingsAreHeld) {
    const std::vector<vec3> level = boxCorners({-1, 1, -1}, {1, 1, 1}), line{{0, 0, 0}, {0, 0, 1}};
    for (const vec4& light : {vec4(0, 5, 0, 1), vec4(0, 1, 0, 0), vec4(3, 1.5, 0, 1)}) {
        for (const auto& points : {level, line}) {
            const Range range = onMap(fitLightView(light, points), points);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(range.low[axis], 0);
                EXPECT_LE(range.high[axis], 1);
            }
        }
    }
}

// However large the margin, the near plane stays before the light.
TEST(LightView, NearPlaneStaysBeforeTheLight) {
    for (const double distance : {1e-3, 0.1, 1.0, 1e6}) {
        const std::vector<vec3> deep = boxCorners({-1e-4, -1e-4, -1000}, {1e-4, 1e-4, 0});
        const LightView view = fitLightView({0, 0, distance, 1}, deep, 0.4);
        EXPECT_GT(view.bounds.near, 0);
        EXPECT_LT(view.bounds.near, distance);
    }
}

TEST(LightView, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal({0, 9, 0, 1}, {}), "fitLightView: must have points to hold");
    EXPECT_EQ(refusal({0, 9, 0, 1}, {{1, 2, 3}, {1, 2, 3}}), "fitLightView: the points must not all be one, (1, 2, 3)");
    EXPECT_EQ(refusal({0, 1, 0.5, 1}, corners), "fitLightView: the light must not be amid the points, (0, 1, 0.5)");
    EXPECT_EQ(refusal({0, 1, 0, 1}, corners).rfind("fitLightView: the light must stand clear of the points", 0), 0U);
    EXPECT_EQ(refusal({0, 0, 0, 0}, corners),
              "fitLightView: the light must be a point (w > 0) or a direction (w = 0), (0, 0, 0, 0)");
    EXPECT_EQ(refusal({0, 9, 0, -1}, corners),
              "fitLightView: the light must be a point (w > 0) or a direction (w = 0), (0, 9, 0, -1)");
    EXPECT_EQ(refusal({0, 9, 0, 1}, corners, 0.5), "fitLightView: the margin must be 0 to 0.4, 0.5");
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal({0, notANumber, 0, 1}, corners), "fitLightView: the light must be finite, (0, nan, 0, 1)");
    EXPECT_EQ(refusal({0, 9, 0, 1}, {{0, 0, 0}, {notANumber, 0, 0}}),
              "fitLightView: each point must be finite, (nan, 0, 0)");
}

TEST(LightView, PointsOfASceneAreInWorldSpace) {
    Scene scene;
    scene.objects.push_back({.name = "box", .mesh = box({0, 0, 0}, {1, 1, 1}), .worldFromObject = translate(5, 0, 0)});
    scene.objects.push_back({.name = "floor", .mesh = square(), .casts = false});
    EXPECT_EQ(casterPoints(scene).size(), 36U);
    EXPECT_EQ(scenePoints(scene).size(), 42U);
    for (const vec3& p : casterPoints(scene)) EXPECT_GE(p.x, 5);
}

}  // namespace
