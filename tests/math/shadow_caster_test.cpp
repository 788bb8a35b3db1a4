#include "mv/math/shadow_caster.h"

#include <array>

#include "mv/math/shadow.h"
#include "support.h"

using namespace mv;
using namespace mv::test;

namespace {

// A unit square whose two sides are at these heights.
std::array<vec3, 4> slab(double low, double high) {
    return {vec3(-0.5, low, 0.5), vec3(-0.5, low, -0.5), vec3(0.5, high, -0.5), vec3(0.5, high, 0.5)};
}

CasterVerdict judge(double low, double high, const vec4& light) {
    const auto corners = slab(low, high);
    return judgeCaster("square", corners, light, ground);
}

TEST(JudgeCaster, SaysNothingOfAWholeShadow) {
    const CasterVerdict verdict = judge(0.25, 0.75, {0, 2, 1, 1});
    EXPECT_TRUE(verdict.casts);
    EXPECT_EQ(verdict.sentence, "");
    EXPECT_EQ(judge(0, 0.5, {0, 2, 1, 1}).sentence, "");  // standing on the floor
    EXPECT_EQ(judge(5, 9, {0.1, 1, 0, 0}).sentence, "");  // a light at infinity is above everything
}

// The verdict agrees with the bounds that cut: some point of the caster is inside both, or none is.
TEST(JudgeCaster, AgreesWithTheBounds) {
    Random random(21);
    int casting = 0;
    for (int i = 0; i < 500; ++i) {
        const vec4 light(random.number(-1, 1), random.number(0.1, 2), 0, 1);
        const double low = random.number(-1, 3), high = random.number(-1, 3);
        const auto bounds = shadowCasterBounds(light, ground);
        bool any = false;
        for (int step = 0; step <= 1000; ++step) {
            const vec4 p(0, low + (high - low) * step / 1000, 0, 1);
            any |= glm::dot(bounds[0], p) > 0 && glm::dot(bounds[1], p) > 0;
        }
        EXPECT_EQ(judge(low, high, light).casts, any) << low << ".." << high << " under " << light.y;
        casting += any;
    }
    EXPECT_GT(casting, 100);
    EXPECT_LT(casting, 400);
}

TEST(JudgeCaster, X11AboveTheLight) {
    const CasterVerdict none = judge(0.5, 0.5, {0, 0.25, 1, 1});
    EXPECT_FALSE(none.casts);
    EXPECT_EQ(none.sentence, "The light is below the square: it casts no shadow on the floor.");
    const CasterVerdict part = judge(0.25, 0.75, {0, 0.5, 1, 1});
    EXPECT_TRUE(part.casts);
    EXPECT_EQ(part.sentence, "Only the part of the square below the light casts a shadow.");
}

TEST(JudgeCaster, X12AtTheLightsHeight) {
    EXPECT_EQ(judge(0.5, 0.5, {0, 0.5, 1, 1}).sentence,
              "The square is as high as the light: its shadow would lie at infinity.");
    // 0.1 + 0.2 is not 0.3, and nobody means the difference.
    EXPECT_FALSE(judge(0.1 + 0.2, 0.3, {0, 0.3, 1, 1}).casts);
    EXPECT_TRUE(judge(0.3 - 1e-9, 0.3, {0, 0.3, 1, 1}).casts);
}

TEST(JudgeCaster, X13BehindTheFloor) {
    EXPECT_EQ(judge(-0.5, 0, {0, 2, 1, 1}).sentence, "The square is not above the floor: no shadow of it falls there.");
    EXPECT_EQ(judge(-0.5, 0.5, {0, 2, 1, 1}).sentence, "Only the part of the square above the floor casts a shadow.");
    EXPECT_EQ(judge(-0.5, 2.5, {0, 2, 1, 1}).sentence,
              "Only the part of the square between floor and light casts a shadow.");
}

TEST(JudgeCaster, X14LightInOrBelowTheFloor) {
    for (const double height : {0.0, 9e-7, -9e-7}) {
        EXPECT_EQ(judge(0.5, 0.5, {0, height, 1, 1}).sentence, "The light lies in the floor: there is no shadow.");
        EXPECT_EQ(lightSide({0, height, 1, 1}, ground), 0);
    }
    EXPECT_EQ(judge(0.5, 0.5, {0, -1, 1, 1}).sentence,
              "The light is below the floor: no shadow falls on its upper side.");
    EXPECT_EQ(lightSide({0, -1, 1, 1}, ground), -1);
    EXPECT_EQ(lightSide({0, -1, 1, 1}, -ground), 1);
    // Side 0 is exactly what shadowProjection refuses.
    for (const double height : {0.0, 1e-7, 9.99e-7, 1.01e-6, 1.0}) {
        const vec4 light(0, height, 1, 1);
        const bool refused = refusal([&] { shadowProjection(light, ground); }) != "nothing was refused";
        EXPECT_EQ(lightSide(light, ground) == 0, refused) << height;
    }
}

// The same verdicts in words that fit an upright plane: here x = 0, its front at positive x.
TEST(JudgeCaster, SpeaksOfWalls) {
    const auto judgeAtWall = [](double near, double far, double lightX) {
        const std::array<vec3, 2> corners{vec3(near, 1, 0), vec3(far, 2, 0)};
        return judgeCaster("cube", corners, {lightX, 5, 0, 1}, {1, 0, 0, 0}, PlaneKind::wall);
    };
    EXPECT_EQ(judgeAtWall(1, 2, 3).sentence, "");
    EXPECT_EQ(judgeAtWall(1, 2, 0).sentence, "The light lies in the plane of the wall: no shadow falls there.");
    EXPECT_EQ(judgeAtWall(1, 2, -1).sentence, "The light is behind the wall: no shadow falls on its front.");
    EXPECT_EQ(judgeAtWall(-2, -1, 3).sentence, "The cube is not in front of the wall: no shadow of it falls there.");
    EXPECT_EQ(judgeAtWall(3, 3, 3).sentence,
              "The cube is as far from the wall as the light: its shadow would lie at infinity.");
    EXPECT_EQ(judgeAtWall(4, 5, 3).sentence,
              "The light is nearer to the wall than the cube: it casts no shadow there.");
    EXPECT_EQ(judgeAtWall(2, 4, 3).sentence,
              "Only the part of the cube nearer to the wall than the light casts a shadow there.");
    EXPECT_EQ(judgeAtWall(-1, 2, 3).sentence, "Only the part of the cube in front of the wall casts a shadow there.");
    EXPECT_EQ(judgeAtWall(-1, 4, 3).sentence, "Only the part of the cube between wall and light casts a shadow there.");
    for (const double near : {-2.0, -1.0, 1.0, 2.0, 4.0}) {
        for (const double light : {-1.0, 0.0, 3.0}) {
            const std::array<vec3, 2> corners{vec3(near, 1, 0), vec3(near + 1, 2, 0)};
            const vec4 lamp(light, 5, 0, 1), wall(1, 0, 0, 0);
            EXPECT_EQ(judgeCaster("cube", corners, lamp, wall, PlaneKind::wall).casts,
                      judgeCaster("cube", corners, lamp, wall).casts);
        }
    }
}

TEST(JudgeCaster, Refusals) {
    EXPECT_EQ(refusal([] {
                  judgeCaster("square", {}, {0, 2, 0, 1}, ground);
              }),
              "judgeCaster: the caster must have a corner, none");
    EXPECT_EQ(refusal([] {
                  judge(notANumber, 0, {0, 2, 0, 1});
              }),
              "judgeCaster: each corner must be finite, (-0.5, nan, 0.5)");
    EXPECT_EQ(refusal([] {
                  lightSide({0, 2, 0, -1}, ground);
              }),
              "lightSide: the light's w must be 0 (direction) or positive (point), (0, 2, 0, -1)");
}

}  // namespace
