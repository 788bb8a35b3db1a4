// The claims of frame-rate, and a test for each.
//
// - [right-ones-agree] After an hour, at an irrational speed, what is moved per second and what is a function of the time
//   agree to 1e-12, whatever the display does; what goes in steps is where they were less than two steps before.
// - [wrong-by-its-ratio] What is moved per picture goes display/60 times as fast, and slower where pictures are left out.
// - [displays] Beside each other on three displays stands what the first way shows on each of them alone.
// - [made-for-60] The first three ways look the same on a display of 60 Hz that keeps up.
// - [hands-turn-backwards] The slide's positive angles turn the hands the wrong way.
// - [bounces-come-closer] The slide's ball comes down at even times, and does not fall freely between them; the falling one does, and
//   each of its flights lasts three quarters of the one before.
// - [spiral] Where a step takes longer to compute than it lasts, each picture takes longer than the one before; with a cap
//   it does not, and time is lost.
// - [same-frame] A frame does not depend on the frames drawn before it, or on knobs moved meanwhile.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "frame-rate/frame-rate.h"
#include "mv/show/session.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// The frame `index` after so many hours; what each way's time is off by, in seconds.
struct Off {
    double perPicture, perSecond, inSteps;
};
Off offAfter(DemoRun& run, int index) {
    (void)run.picture(index);
    return {run.readout("per-picture-off"), run.readout("per-second-off"), run.readout("steps-off")};
}

// An irrational speed: no turn of it ends where another began.
const char* const irrational = "141.4213562373095";

}  // namespace

TEST(FrameRateFull, right_ones_agree) {
    DemoRun run("frame-rate", 240, 140);
    run.set("speed", irrational).set("hours", 1);
    for (const char* display : {"59.94", "60", "144", "240"}) {
        for (const bool isSmooth : {true, false}) {
            SCOPED_TRACE(std::string(display) + (isSmooth ? "" : ", with late pictures"));
            run.set("display", display).set("jitter", isSmooth ? 0 : 12).set("hiccup", isSmooth ? 0 : 300);
            const Off off = offAfter(run, 600);
            // 3610 s, of which 1e-12 is 3.6e-9 s
            EXPECT_LE(std::abs(off.perSecond), 1e-12 * 3610);
            const double turned = std::abs(run.readout("turn-per-second") - run.readout("turn-of-time"));
            EXPECT_LE(std::min(turned, 360 - turned), 1e-12 * 3610 * 141.43);
            // Between two steps it shows where things were one step before, and what is owed is less than another; what
            // the cap has dropped is gone.
            const double inSteps = off.inSteps + run.readout("lost");
            EXPECT_LE(inSteps, 1e-6);
            EXPECT_GE(inSteps, -2.0 / 60);
            EXPECT_EQ(run.readout("lost") > 0, !isSmooth);
        }
    }
    // As floats a second is what an hour of 240ths loses: the check can fail.
    EXPECT_GT(std::abs(offAfter(run.set("sum", "float"), 600).perSecond), 1e-3);
    EXPECT_LE(std::abs(offAfter(run.set("sum", "compensated"), 600).perSecond), 1e-15 * 3610);
    EXPECT_EQ(offAfter(run.set("sum", "product"), 600).perSecond, 0);
}

TEST(FrameRateFull, wrong_by_its_ratio) {
    DemoRun run("frame-rate", 240, 140);
    run.set("hours", 1);
    const std::vector<std::pair<const char*, double>> displays{
        {"59.94", 60'000 / 1001.0}, {"60", 60}, {"144", 144}, {"240", 240}};
    for (const auto& [display, hertz] : displays) {
        const double off = offAfter(run.set("display", display), 0).perPicture;
        // A picture more or less at the end
        EXPECT_NEAR(off, 3600 * (hertz / 60 - 1), hertz / 3600 + 1.5 / 60) << display;
    }
    // A picture that takes 20 ms is shown at every third refresh of 144 Hz: 48 a second, so 0.8 of the speed.
    EXPECT_NEAR(offAfter(run.set("display", "144").set("load", 20), 0).perPicture, 3600 * (48 / 60.0 - 1), 0.1);
}

TEST(FrameRate, displays) {
    DemoRun run("frame-rate", 960, 560);
    run.set("jitter", 5).set("hours", 0.3);
    const Picture beside = run.picture(90);
    run.set("beside", "ways");
    const std::vector<const char*> displays{"60", "144", "240"};
    for (int column = 0; column < 3; ++column) {
        const Picture alone = run.set("display", displays[std::size_t(column)]).picture(90);
        long differing = 0, seen = 0;
        for (int y = 90; y < 400; ++y) {  // below the name of the column, above the plot
            for (int x = 0; x < 240; ++x) {
                differing += alone.at(x, y) != beside.at(240 * column + x, y);
                seen += alone.at(x, y) != alone.at(0, y);
            }
        }
        // Places in another pane are rounded anew, which a pixel at an edge may tell; another display differs in thousands
        EXPECT_LE(differing, 20) << displays[std::size_t(column)];
        EXPECT_GT(seen, 5000);
    }
}

TEST(FrameRate, made_for_60) {
    DemoRun run("frame-rate", 240, 140);
    run.preset("made-for-60");
    for (const int index : {1, 60, 3600}) {
        const Off off = offAfter(run, index);
        // 3600 additions of a 60th, each rounded by at most half a place of 60: 1.3e-11
        EXPECT_NEAR(off.perPicture, 0, 2e-11) << index;
        EXPECT_NEAR(off.perSecond, 0, 2e-11) << index;
    }
    // The difference shows where pictures are late.
    EXPECT_LT(offAfter(run.set("load", 20), 3600).perPicture, -20);
}

// After 15 minutes the long hand points at the three, or at the nine.
TEST(FrameRate, hands_turn_backwards) {
    DemoRun run("frame-rate", 960, 560);
    run.set("beside", "ways").set("hours", 0.25).set("display", "60");
    const auto blueOnSide = [&](bool isRight) {
        const Picture picture = run.picture(0);
        long count = 0;
        // The clock of the third pane, which is right: its middle is 0.36 and 0.625 of the pane.
        const int middleX = 480 + 86, middleY = 420 - static_cast<int>(0.625 * 420);
        for (int x = 20; x < 50; ++x) {
            for (int y = -3; y <= 3; ++y) {
                const Pixel pixel = picture.at(middleX + (isRight ? x : -x), middleY + y);
                count += pixel.blue > 150 && pixel.red < 100;
            }
        }
        return count;
    };
    const long right = blueOnSide(true), left = blueOnSide(false);
    EXPECT_GT(right, 20);
    EXPECT_EQ(left, 0);
    run.set("hands", "as-written");
    EXPECT_EQ(blueOnSide(true), 0) << "grey: where it ought to be";
    EXPECT_GT(blueOnSide(false), 20);
}

TEST(FrameRate, spiral) {
    DemoRun run("frame-rate", 240, 140);
    run.preset("no-cap").set("hours", 0);
    std::vector<double> lasting;
    for (const int index : {30, 120, 600, 3600, 20000}) {
        (void)run.picture(index);
        lasting.push_back(run.readout("picture-lasts"));
    }
    for (std::size_t i = 1; i < lasting.size(); ++i) EXPECT_GT(lasting[i], 1.5 * lasting[i - 1]) << i;
    EXPECT_EQ(run.readout("lost"), 0);
    // With the cap a picture lasts at most five steps and its drawing, and a refresh more.
    run.set("cap", "on");
    for (const int index : {120, 3600, 20000}) {
        (void)run.picture(index);
        EXPECT_LE(run.readout("picture-lasts"), 5 * 20 + 2 + 1000 / 144.0) << index;
    }
    // What a step takes, 20 ms, it is short of its 16.7 for, and of what is drawn beside.
    EXPECT_GT(run.readout("lost"), 20000 / 60.0 * (1 - 16.7 / 20));
    EXPECT_LT(run.readout("steps-off"), -50);
    // Steps that are computed in time leave nothing owed.
    (void)run.set("step-load", 5).picture(20000);
    EXPECT_EQ(run.readout("lost"), 0);
}

TEST(FrameRateFull, same_frame) {
    DemoRun run("frame-rate", 240, 140);
    run.set("hours", 0).set("jitter", 9).set("hiccup", 200);
    const Picture late = run.picture(500), early = run.picture(40);
    EXPECT_NE(late, early);
    EXPECT_EQ(run.picture(500), late);
    EXPECT_EQ(run.picture(40), early);

    // Somebody plays: loads the machine at frame 100 and relieves it at 200. A copied command shows the same.
    const std::vector<KnobSetting> knobs{{"hours", "0"}, {"jitter", "9"}};
    Picture played;
    std::vector<TimedChange> changes;
    {
        Session session(stage(), findDemo("frame-rate"), {.width = 240, .height = 140, .knobs = knobs, .paused = true});
        for (int index = 1; index <= 300; index += 3) {
            session.playback().goTo(index);
            if (index == 100) (void)session.set("load", "40");
            if (index == 202) (void)session.set("load", "2");
            session.touch();
            session.draw(240, 140, false);
        }
        played = stage().picture();
        changes = stage().timeline().changesUntil(298);
    }
    EXPECT_EQ(changes, (std::vector<TimedChange>{{97, "load", "40"}, {199, "load", "2"}}));
    stage().open(findDemo("frame-rate"), 240, 140);
    stage().begin(knobs, changes);
    stage().draw(298);
    EXPECT_EQ(stage().picture(), played);
    // The changes matter: without them it is another picture.
    stage().open(findDemo("frame-rate"), 240, 140);
    stage().begin(knobs);
    stage().draw(298);
    EXPECT_NE(stage().picture(), played);
    stage().close();
}

TEST(FrameRate, bounces_come_closer) {
    using namespace mv::frame_rate;
    constexpr double h = 1e-4;
    // When the ball is lower than just before and after, up to `end`; and the largest change of its acceleration away from these times, as a
    // part of it.
    struct Motion {
        std::vector<double> bounces;
        double uneven = 0;
    };
    const auto motionOf = [&](Ball ball, double end) {
        Motion motion;
        const auto at = [&](double t) { return ballHeight(ball, t); };
        const auto acceleration = [&](double t) { return (at(t - h) - 2 * at(t) + at(t + h)) / (h * h); };
        double least = HUGE_VAL, most = 0;
        for (double t = 2 * h; t < end; t += h) {
            if (at(t) < at(t - h) && at(t) <= at(t + h)) motion.bounces.push_back(t);
            if (at(t) < 0.05) continue;  // near a bounce the difference reaches across it
            least = std::min(least, std::abs(acceleration(t))), most = std::max(most, std::abs(acceleration(t)));
        }
        motion.uneven = (most - least) / most;
        return motion;
    };
    const Motion slide = motionOf(Ball::asWritten, 3), falling = motionOf(Ball::falling, 3);
    ASSERT_GE(slide.bounces.size(), 3U);
    ASSERT_GE(falling.bounces.size(), 3U);
    // A bounce is found to a step, so a flight to two
    for (std::size_t i = 2; i < slide.bounces.size(); ++i) {
        EXPECT_NEAR(slide.bounces[i] - slide.bounces[i - 1], slide.bounces[1] - slide.bounces[0], 2 * h);
    }
    for (std::size_t i = 2; i < falling.bounces.size(); ++i) {
        EXPECT_NEAR(falling.bounces[i] - falling.bounces[i - 1],
                    0.75 * (falling.bounces[i - 1] - falling.bounces[i - 2]), 4 * h);
    }
    EXPECT_GT(slide.uneven, 0.5);
    EXPECT_LT(falling.uneven, 1e-4);  // a difference of roundings, 2e-16 / h^2, beside an acceleration of 5
    EXPECT_LT(ballHeight(Ball::falling, 4.8), 1e-12);  // all flights are over
    EXPECT_EQ(ballHeight(Ball::falling, 0), 0);
}
