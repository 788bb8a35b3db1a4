#include "mv/motion/path_frame.h"

#include "curves.h"
#include "math/support.h"
#include "mv/math/robust.h"
#include "mv/math/transform.h"
#include "mv/motion/orientation.h"

using namespace mv;
using namespace mv::test;

namespace {

const vec3 gravity(0, -9.81, 0);

mat3 axesOf(const PathFrame& frame) { return {frame.right, frame.up, -frame.forward}; }

void expectRightHanded(const PathFrame& frame, const vec3& velocity) {
    const mat3 axes = axesOf(frame);
    EXPECT_LT(largestDifference(glm::transpose(axes) * axes, mat3(1)), rounding);
    EXPECT_GT(glm::determinant(axes), 0);
    EXPECT_LT(glm::length(frame.forward - unit(velocity)), rounding);
}

TEST(FrameByUp, IsOrthonormalAndLooksForwardWithItsUpOnTheSideOfUp) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const vec3 velocity = random.logarithmic(1e-200, 1e200) * random.direction();
        const double off = random.logarithmic(2e-12, 3);
        const vec3 up = random.logarithmic(1e-200, 1e200) * (unit(velocity) + off * random.direction());
        if (glm::length(accurateCross(unit(velocity), unit(up))) < 1e-11) continue;
        const PathFrame frame = frameByUp(velocity, up);
        expectRightHanded(frame, velocity);
        EXPECT_LT(std::abs(glm::dot(frame.right, unit(up))), rounding);
        EXPECT_GT(glm::dot(frame.up, unit(up)), 0);
    }
}

TEST(FrameByUp, IsTheCameraOfLookAt) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const vec3 position = random.point(10), velocity = random.point(5), up = random.direction();
        const mat4 world = worldFromFrame(frameByUp(velocity, up), position);
        // Coordinates of up to 10, and up as near as 0.01 rad to the view
        EXPECT_LT(largestDifference(lookAt(position, position + velocity, up) * world, mat4(1)), 1e-11);
        expectRightHanded(frameByUp(velocity, up), velocity);
    }
    const mat4 still = worldFromFrame(PathFrame{}, {1, 2, 3});
    EXPECT_EQ(still, translate(1, 2, 3));
}

TEST(Rolled, TurnsAboutForwardToTheRight) {
    const PathFrame frame = frameByUp({1, 2, 3}, {0, 1, 0});
    EXPECT_LT(glm::length(rolled(frame, 90).up - frame.right), rounding);
    for (const double angle : {-400.0, -30.0, 0.0, 123.0}) {
        const PathFrame turned = rolled(frame, angle);
        expectRightHanded(turned, {1, 2, 3});
        const vec3 up(rotate(angle, frame.forward) * vec4(frame.up, 0));
        EXPECT_LT(glm::length(turned.up - up), 3 * rounding);  // angles of up to 2 pi rad
    }
    EXPECT_EQ(refusal([&] { rolled(frame, notANumber); }), "rolled: the angle must be finite, nan");
}

TEST(TurnedTo, IsTheLeastTurn) {
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const PathFrame frame = frameByUp(random.direction(), random.direction());
        const double angle = i % 2 == 0 ? random.number(0, 179) : random.logarithmic(1e-12, 1);
        const vec3 axis = glm::normalize(glm::cross(frame.forward, random.direction()));  // none of it about forward
        const mat3 turn(rotationMatrix(quatFromAxis(angle, axis)));
        const PathFrame turned = turnedTo(frame, 5.0 * (turn * frame.forward));
        expectRightHanded(turned, turn * frame.forward);
        // The direction of the sum of forwards has roundings over its length, 2 cos(angle/2).
        EXPECT_LT(glm::length(turned.up - turn * frame.up), 2 * rounding / std::cos(radians(angle / 2)));
    }
    EXPECT_EQ(refusal([] {
                  turnedTo(PathFrame{}, {0, 0, 5});
              }),
              "turnedTo: directions must be more than 1e-6 rad off opposite ones, (0, 0, 5)");
}

TEST(Banking, LeansByTheAngleOfTheFlatBend) {
    for (const double speed : {0.1, 5.0, 20.0, 100.0}) {
        const WaveCurve bend = circle(50, speed);
        for (const double t : {0.0, 1.0, 7.3}) {
            const vec3 velocity = bend.derivative(t, 1), acceleration = bend.derivative(t, 2);
            const PathFrame banked = frameByBanking(velocity, acceleration, gravity);
            expectRightHanded(banked, velocity);
            const double lean = degrees(std::atan2(glm::length(glm::cross(banked.up, vec3(0, 1, 0))), banked.up.y));
            // Angles up to 90 degrees, from coordinates of size 100 with roundings of their sines
            EXPECT_NEAR(lean, degrees(std::atan(speed * speed / (9.81 * 50))), 1e-12);
            EXPECT_GT(glm::dot(banked.up, acceleration), 0);  // inwards

            // Slip E22: by the acceleration alone the car lies on its side, at any speed.
            const PathFrame slide = frameByAcceleration(velocity, acceleration);
            EXPECT_NEAR(slide.up.y, 0, rounding);
            EXPECT_NEAR(glm::dot(slide.up, unit(acceleration)), 1, rounding);
        }
    }
    EXPECT_LT(glm::length(frameByBanking({3, 0, 4}, {0, 0, 0}, gravity).up - vec3(0, 1, 0)), rounding);
}

TEST(Samples, AreAtEqualStepsWithBothEnds) {
    const WaveCurve curve = trefoil();
    const auto samples = samplesOf(curve.path(), 0.1, 0.7, 3);
    ASSERT_EQ(samples.size(), 4u);
    for (const auto& [i, t] : {std::pair(0, 0.1), {1, 0.3}, {2, 0.5}, {3, 0.7}}) {
        const PathSample& sample = samples[static_cast<std::size_t>(i)];
        EXPECT_LT(glm::length(sample.position - curve.derivative(t, 0)), 1e-14);
        EXPECT_LT(glm::length(sample.velocity - curve.derivative(t, 1)), 1e-14);
        EXPECT_LT(glm::length(sample.acceleration - curve.derivative(t, 2)), 1e-13);  // sizes of up to 9
    }
    EXPECT_EQ(samples.back().position, curve.derivative(0.7, 0));
    EXPECT_EQ(refusal([&] { samplesOf(curve.path(), 1, 1, 3); }), "samplesOf: the parameters must differ, 1");
    EXPECT_EQ(refusal([&] { samplesOf(curve.path(), 0, 1, 0); }), "samplesOf: there must be at least 1 interval, 0");
    EXPECT_EQ(refusal([] { samplesOf({}, 0, 1, 1); }),
              "samplesOf: a path must have position, velocity and acceleration");
    Path broken = curve.path();
    broken.velocity = [](double) { return vec3(notANumber); };
    EXPECT_EQ(refusal([&] { samplesOf(broken, 0, 1, 1); }), "samplesOf: the velocity must be finite, (nan, nan, nan)");
}

// ---- whole paths, and where their rules fail

TEST(FramesByRule, AreTheFramesOfTheSamplesWhereNothingFails) {
    const auto samples = samplesOf(circle(3, 2).path(), 0, 5, 40);
    const auto fixed = framesByUp(samples, {0, 1, 0}), slide = framesByAcceleration(samples),
               banked = framesByBanking(samples, gravity);
    for (const FramesByRule* run : {&fixed, &slide, &banked}) {
        EXPECT_EQ(run->frames.size(), samples.size());
        EXPECT_TRUE(run->vanished.empty() && run->flipped.empty());
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto& [position, velocity, acceleration] = samples[i];
        EXPECT_EQ(axesOf(fixed.frames[i]), axesOf(frameByUp(velocity, {0, 1, 0})));
        EXPECT_EQ(axesOf(slide.frames[i]), axesOf(frameByAcceleration(velocity, acceleration)));
        EXPECT_EQ(axesOf(banked.frames[i]), axesOf(frameByBanking(velocity, acceleration, gravity)));
    }
    EXPECT_TRUE(framesByUp({}, {0, 1, 0}).frames.empty());
}

TEST(FramesByRule, TheSlidesRuleFlipsAtAnInflectionAndVanishesOnAStraight) {
    // The inflection at pi is between two samples; a level figure of eight, as a road is.
    WaveCurve road = eight();
    for (Wave& wave : road.waves) wave.amplitude = {wave.amplitude.x, 0, wave.amplitude.y};
    const auto samples = samplesOf(road.path(), 0.1, 6, 200);
    const auto slide = framesByAcceleration(samples);
    ASSERT_EQ(slide.flipped.size(), 1u);
    EXPECT_NEAR(0.1 + 5.9 / 200 * static_cast<double>(slide.flipped[0]), pi, 5.9 / 200);
    EXPECT_TRUE(framesByBanking(samples, gravity).flipped.empty());
    EXPECT_TRUE(framesByUp(samples, {0, 1, 0}).flipped.empty());

    // A bend, then a straight: the last frame of the bend goes on. Before any bend up is the world's.
    std::vector<PathSample> straight(3, {{0, 0, 0}, {0, 0, -2}, {0, 0, 0}});
    straight[1].acceleration = {1, 0, 0};
    const auto run = framesByAcceleration(straight);
    EXPECT_EQ(run.vanished, (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(run.frames[0].up, vec3(0, 1, 0));
    EXPECT_LT(glm::length(run.frames[2].up - vec3(1, 0, 0)), rounding);
    EXPECT_TRUE(framesByBanking(straight, gravity).vanished.empty());
    for (const PathFrame& frame : run.frames) expectRightHanded(frame, {0, 0, -2});
}

TEST(FramesByRule, FixedUpTurnsOverInALoopAndBankingDoesNot) {
    // A vertical loop of radius 5, begun at its foot
    const double radius = 5;
    const auto loop = [&](double speed) {
        return WaveCurve{{{{0, -radius, 0}, speed / radius, pi / 2}, {{radius, 0, 0}, speed / radius, 0}}};
    };
    const double fast = 12, lap = 2 * pi * radius / fast;
    const auto samples = samplesOf(loop(fast).path(), 0, lap, 101);
    const auto fixed = framesByUp(samples, {0, 1, 0});
    EXPECT_EQ(fixed.flipped.size(), 2u);  // going straight up and straight down
    const auto banked = framesByBanking(samples, gravity);
    EXPECT_TRUE(banked.flipped.empty() && banked.vanished.empty());
    EXPECT_LT(banked.frames[50].up.y, -0.9);  // at the top, upside down

    // The frame of a sample that goes straight up is carried on.
    const auto quarters = samplesOf(loop(fast).path(), 0, lap, 8);
    const auto run = framesByUp(quarters, {0, 1, 0});
    EXPECT_EQ(run.vanished, (std::vector<std::size_t>{2, 6}));
    EXPECT_LT(glm::length(run.frames[2].up - vec3(-1, 0, 0)), rounding);
    // Too slow: at the top the car would fall, and up is up again.
    EXPECT_GT(framesByBanking(samplesOf(loop(3).path(), 0, 2 * pi * radius / 3, 101), gravity).frames[50].up.y, 0.9);
}

TEST(PathFrame, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] {
                  frameByUp({0, 0, 0}, {0, 1, 0});
              }),
              "frameByUp: the velocity must not be 0: a cusp has no forward, (0, 0, 0)");
    EXPECT_EQ(refusal([] {
                  frameByUp({0, 3, 0}, {0, -1, 0});
              }),
              "frameByUp: up must be more than 1e-12 rad off the velocity's line, and not 0, (0, -1, 0)");
    EXPECT_NE(refusal([] { frameByUp({0, 3, 0}, {9e-13, -1, 0}); }), "nothing was refused");
    EXPECT_EQ(refusal([] { frameByUp({0, 3, 0}, {1.1e-12, -1, 0}); }), "nothing was refused");
    EXPECT_EQ(refusal([] { frameByUp({0, 3, 0}, {0, 0, infinite}); }), "frameByUp: up must be finite, (0, 0, inf)");
    EXPECT_EQ(refusal([] {
                  frameByAcceleration({1, 0, 0}, {0, 0, 0});
              }),
              "frameByAcceleration: the acceleration must be more than 1e-12 rad off the velocity's line, and not 0, "
              "(0, 0, 0)");
    EXPECT_EQ(refusal([] {
                  frameByBanking({1, 0, 0}, gravity, gravity);
              }),
              "frameByBanking: acceleration - gravity must be more than 1e-12 rad off the velocity's line, and not 0, "
              "(0, 0, 0)");
    std::vector<PathSample> samples(3, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
    samples[2].velocity = vec3(0);
    EXPECT_EQ(refusal([&] {
                  framesByUp(samples, {0, 1, 0});
              }),
              "framesByUp, sample 2: the velocity must not be 0: a cusp has no forward, (0, 0, 0)");
    samples[1].position.y = notANumber;
    EXPECT_EQ(refusal([&] { framesByBanking(samples, gravity); }),
              "framesByBanking, sample 1: the position must be finite, (0, nan, 0)");
}

}  // namespace
