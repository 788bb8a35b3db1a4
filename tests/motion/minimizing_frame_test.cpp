#include "mv/motion/minimizing_frame.h"

#include <array>

#include "curves.h"
#include "math/support.h"
#include "mv/math/robust.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr std::array transports{Transport::reorthogonalize, Transport::project, Transport::rotate,
                                Transport::doubleReflection};

// The angle by which Frenet's frame turns about the path from one parameter to the other, in degrees: the minimizing frame turns back
// by that. Simpson's rule on 2000 intervals, off by 1e-11 of it here: another method than those under test.
double totalTorsion(const WaveCurve& curve, double from, double to) {
    const int intervals = 2000;
    const double step = (to - from) / intervals;
    double sum = curve.torsionRate(from) + curve.torsionRate(to);
    for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * curve.torsionRate(from + i * step);
    return degrees(sum * step / 3);
}

PathFrame frenetFrame(const WaveCurve& curve, double t) {
    return frameByAcceleration(curve.derivative(t, 1), curve.derivative(t, 2));
}

// The degrees by which the last frame is off that of Frenet's turned back, from many steps of one transport.
double twistError(const WaveCurve& curve, double from, double to, int intervals, Transport transport) {
    const auto samples = samplesOf(curve.path(), from, to, intervals);
    const auto frames = minimizingFrames(samples, frenetFrame(curve, from).up, transport);
    return closingAngle(rolled(frenetFrame(curve, to), -totalTorsion(curve, from, to)), frames.back());
}

TEST(MinimizingFrames, AreOrthonormalAndFollowTheTangent) {
    for (const Transport transport : transports) {
        const auto samples = samplesOf(trefoil().path(), 0, 2 * pi, 300);
        const auto frames = minimizingFrames(samples, {0, 1, 0}, transport);
        ASSERT_EQ(frames.size(), samples.size());
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const mat3 axes(frames[i].right, frames[i].up, -frames[i].forward);
            EXPECT_LT(largestDifference(glm::transpose(axes) * axes, mat3(1)), rounding);
            EXPECT_GT(glm::determinant(axes), 0);
            EXPECT_LT(glm::length(frames[i].forward - unit(samples[i].velocity)), rounding);
        }
    }
}

// The error falls with the step's power. All errors are above 1e-9 degrees, where the roundings of 320 chords, 1e-16 *
// 320 * 57 = 2e-12, do not show. A slope that is off by 0.2 would have a next term of 15 % of the first: with steps of
// 1/30 to 1/120 of a radian that term is some hundredths.
TEST(MinimizingFrames, ErrorsFallByTheirOrders) {
    const std::array order{1.0, 2.0, 2.0, 4.0};
    for (std::size_t i = 0; i < transports.size(); ++i) {
        double last = 0;
        for (int intervals = 80; intervals <= 320; intervals *= 2) {
            const double error = std::abs(twistError(trefoil(), 0.3, 2.9, intervals, transports[i]));
            EXPECT_GT(error, 1e-9);
            if (last > 0) {
                EXPECT_NEAR(std::log2(last / error), order[i], 0.2) << i << ", " << intervals << ": " << error;
            }
            last = error;
        }
    }
}

TEST(MinimizingFrames, TurnBackByTheTorsionOfAHelix) {
    const double radius = 2, rise = 0.7, turn = 5 * pi;
    const WaveCurve curve = helix(radius, rise);
    // Closed form: torsion rise/(radius^2 + rise^2) for each unit of length.
    const double speed = std::hypot(radius, rise), torsion = degrees(rise / (speed * speed) * speed * turn);
    EXPECT_NEAR(totalTorsion(curve, 0, turn), torsion, 1e-9);
    const auto samples = samplesOf(curve.path(), 0, turn, 2000);
    const auto frames = minimizingFrames(samples, frenetFrame(curve, 0).up);
    // The fourth power of a step of 8e-3, times the angle
    EXPECT_NEAR(closingAngle(rolled(frenetFrame(curve, turn), -torsion), frames.back()), 0, 1e-6);
    // and half way, where an error that closes again would show
    EXPECT_NEAR(closingAngle(rolled(frenetFrame(curve, turn / 2), -torsion / 2), frames[1000]), 0, 1e-6);
}

TEST(MinimizingFrames, DoNotTwistInAPlane) {
    // An oblique up keeps its angle to the plane, at inflections and at any step, where the transport is a turn. The other two
    // fail: one drops a part of up, and one makes it longer or shorter, unless it is along the normal.
    const vec3 normal(0, 0, 1);
    const auto samples = samplesOf(eight().path(), 0, 2 * pi, 24);
    for (const Transport transport : transports) {
        const auto frames = minimizingFrames(samples, vec3(-1, 1, 1), transport);
        double most = 0;
        for (const PathFrame& frame : frames) {
            most = std::max(most, std::abs(glm::dot(frame.up, normal) - glm::dot(frames[0].up, normal)));
        }
        if (transport == Transport::rotate || transport == Transport::doubleReflection) {
            EXPECT_LT(most, 24 * rounding);
            EXPECT_NEAR(closingAngle(frames.front(), frames.back()), 0, 24 * degrees(rounding));
        } else {
            EXPECT_GT(most, 1e-2);
        }
        for (const PathFrame& frame : minimizingFrames(samples, normal, transport)) {
            EXPECT_LT(glm::length(frame.up - normal), rounding);
        }
    }
}

TEST(MinimizingFrames, DoNotDependOnSizeOrSpeed) {
    const auto samples = samplesOf(trefoil().path(), 0, 3, 50);
    for (const Transport transport : transports) {
        const auto frames = minimizingFrames(samples, {0, 1, 0}, transport);
        for (const double size : {0x1p-500, 0x1p500}) {
            auto scaled = samples;
            for (PathSample& sample : scaled) {
                sample.position *= size;
                sample.velocity *= size;
            }
            const auto same = minimizingFrames(scaled, {0, 1, 0}, transport);
            EXPECT_LT(glm::length(same.back().up - frames.back().up), 50 * rounding);
        }
    }
}

TEST(MinimizingFrames, StandStillWhereThePathDoes) {
    auto samples = samplesOf(trefoil().path(), 0, 3, 50);
    samples.insert(samples.begin() + 20, samples[20]);
    for (const Transport transport : transports) {
        const auto frames = minimizingFrames(samples, {0, 1, 0}, transport);
        EXPECT_LT(glm::length(frames[21].up - frames[20].up), rounding);
    }
}

// ---- closed paths

TEST(ClosingAngle, IsTheTotalTorsionOfAClosedCurve) {
    const auto samples = samplesOf(trefoil().path(), 0, 2 * pi, 4000);
    const auto frames = minimizingFrames(samples, {0, 1, 0});
    const double angle = closingAngle(frames.front(), frames.back());
    EXPECT_GT(std::abs(angle), 10);
    // The fourth power of a step of 1.6e-3, times the angle and the curve's derivatives; Simpson's rule has less
    EXPECT_NEAR(std::remainder(angle + totalTorsion(trefoil(), 0, 2 * pi), 360.0), 0, 1e-6);
}

TEST(ClosingAngle, IsNothingOnASphere) {
    // Whatever the curve, if it lies on a sphere: its total torsion is 0.
    const auto samples = samplesOf(viviani().path(), 0, 4 * pi, 4000);
    const auto frames = minimizingFrames(samples, {1, 0, 0});
    EXPECT_NEAR(closingAngle(frames.front(), frames.back()), 0, 1e-6);
    EXPECT_GT(std::abs(closingAngle(frames.front(), turnedTo(frames[1000], frames[0].forward))), 1);  // not so between
}

TEST(ClosingAngle, IsWhatTheFrameWasRolledBy) {
    const PathFrame frame = frameByUp({1, 2, 3}, {0, 1, 0});
    for (const double angle : {-179.0, -1e-9, 0.0, 50.0, 180.0}) {
        EXPECT_NEAR(closingAngle(frame, rolled(frame, angle)), angle, 1e-13);
    }
    EXPECT_EQ(refusal([&] {
                  closingAngle(frame, turnedTo(frame, {1, 2, 3.01}));
              }).rfind("closingAngle: the path must end in the direction in which it began, (", 0),
              0u);
}

TEST(ClosedFrames, CloseAndTwistEvenly) {
    const auto samples = samplesOf(trefoil().path(), 0, 2 * pi, 400);
    const auto open = minimizingFrames(samples, {0, 1, 0});
    const auto closed = closedFrames(samples, open);
    ASSERT_EQ(closed.size(), samples.size());
    EXPECT_LT(glm::length(closed.front().up - open.front().up), rounding);
    EXPECT_LT(glm::length(closed.back().up - closed.front().up), 3 * rounding);

    double way = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) way += glm::length(samples[i].position - samples[i - 1].position);
    const double angle = closingAngle(open.front(), open.back());
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double step = glm::length(samples[i].position - samples[i - 1].position);
        const double twist = closingAngle(open[i], closed[i]) - closingAngle(open[i - 1], closed[i - 1]);
        EXPECT_NEAR(twist, -angle * step / way, 1e-12);  // differences of angles of up to 180 degrees
        EXPECT_EQ(closed[i].forward, open[i].forward);
    }
}

TEST(MinimizingFrames, RefusalsSayWhatWouldHaveBeenRight) {
    auto samples = samplesOf(trefoil().path(), 0, 3, 50);
    const auto refused = [&](std::size_t i, const vec3& position, const vec3& velocity, Transport transport) {
        auto broken = samples;
        broken[i] = {position, velocity, vec3(0)};
        return refusal([&] { minimizingFrames(broken, {0, 1, 0}, transport); });
    };
    const vec3 position = samples[7].position, velocity = samples[7].velocity;
    EXPECT_EQ(refused(7, position, vec3(0), Transport::doubleReflection),
              "minimizingFrames, sample 7: the velocity must not be 0: a cusp has no forward, (0, 0, 0)");
    EXPECT_EQ(
        refused(7, position, -velocity, Transport::rotate),
        "minimizingFrames: tangents must be less than 90 degrees apart: more samples are needed, between 6 and 7");
    for (const Transport transport : {Transport::project, Transport::doubleReflection}) {
        EXPECT_EQ(refused(7, samples[5].position, velocity, transport),
                  "minimizingFrames: the chord must be within 90 degrees of its tangents: more samples are needed, "
                  "between 6 and 7");
    }
    EXPECT_EQ(refused(7, vec3(-1.7e308), velocity, Transport::rotate), "nothing was refused");
    EXPECT_NE(refused(7, vec3(notANumber), velocity, Transport::rotate), "nothing was refused");
    EXPECT_EQ(refusal([&] { minimizingFrames(samples, samples[0].velocity); }).rfind("frameByUp: up must be more", 0),
              0u);
    EXPECT_TRUE(minimizingFrames({}, {0, 1, 0}).empty());

    const auto frames = minimizingFrames(samples, {0, 1, 0});
    EXPECT_EQ(refusal([&] { closedFrames(samples, {}); }),
              "closedFrames: there must be a frame to each sample, and two at least, 0 frames, 51 samples");
    EXPECT_EQ(refusal([&] { closedFrames(samples, frames); }).rfind("closedFrames: the path must end where it", 0), 0u);
    const std::vector<PathSample> still(2, samples[0]);
    EXPECT_EQ(refusal([&] {
                  closedFrames(still, {frames[0], frames[0]});
              }),
              "closedFrames: the length of the path must be greater than 0 and finite, 0");
}

}  // namespace
