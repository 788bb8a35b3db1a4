// The claims of springs, and a test for each; rows X33 to X35 of docs/stability.md.
//
// - [limits] One spring grows where the region says so, and not within 1 % below it: damped or not, by each method.
// - [dots-tell] By velocity Verlet chain, net and cloth blow up where a dot is outside; with one substep more than leaves
//   none outside they do not.
// - [stops-in-words] A simulation that blows up stops at its last finite state, and the picture says at which step and why.
// - [falls-asleep] At w h = 16.7 implicit Euler has lost all but 0.4 % of the energy after a step, without damping.
// - [phase] At the same w h implicit midpoint keeps the energy to 1e-9, and turns by 2.9 rad a step instead of 16.7.
// - [rest-lengths] Three stiff masses with rest lengths: no dot is outside, and implicit midpoint loses half of the energy
//   although its steps are halved; energy-momentum keeps it to 1e-9.
// - [balance] Energy + dissipated - work stays level while somebody plays: by energy-momentum to 1e-9 of it, and by a
//   method of order 4 16 times better for half the step.
// - [default-is-cheapest] How it opens it keeps that to 1e-3 for five seconds, and no explicit method does by fewer
//   evaluations.
// - [rests] Resting masses are neither stepped nor uploaded.
// - [classics] On stiff problems RODAS ends at the published values, and an explicit method says that it cannot.
// - [confirmed] Where a tolerance of 1e-2 ends wrong, a second run by a tenth of it raises a doubt, and one is not
//   raised where each classic ends right.
// - [same-frame] A frame is the same whatever was drawn before it; a game played by hand, copied, gives the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "mv/math/types.h"
#include "mv/motion/ode_stability.h"
#include "mv/paper/audit.h"
#include "mv/show/session.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::array<const char*, 11> words{"explicit-euler",
                                        "symplectic-euler",
                                        "velocity-verlet",
                                        "explicit-midpoint",
                                        "runge-kutta-4",
                                        "dormand-prince",
                                        "implicit-euler",
                                        "implicit-midpoint",
                                        "bdf2",
                                        "rodas",
                                        "energy-momentum"};

double after(DemoRun& run, int frame, const char* readout) {
    (void)run.picture(frame);
    return run.readout(readout);
}

// One spring, a step a frame, at w h = wh.
DemoRun& swing(DemoRun& run, double wh, double ratio) {
    const double w = 60 * wh;
    return run.set("problem", "spring").set("substeps", 1).set("stiffness", w * w).set("damping", 2 * ratio * w);
}

// The largest w h up to 10 below which nothing grows, by the method's stability function, and 0 where all does.
double limitOf(OdeMethod method, double ratio) {
    const std::complex<double> direction(-ratio, std::sqrt(1 - ratio * ratio));
    double wh = 0.05;
    // 1e-9: what a step of it grows by is rounding
    while (wh < 10 && amplification(method, wh * direction) <= 1 + 1e-9) wh += 1e-4;
    return wh <= 0.05 ? 0 : wh;
}

// The logarithm of what a step multiplies the swing by, in the long run: of the largest energies in two windows, each
// longer than a phase needs to come round.
double growth(DemoRun& run, int from, int to) {
    constexpr int window = 16;
    const auto largest = [&](int first) {
        double most = 0;
        for (int i = 0; i < window; ++i) most = std::max(most, after(run, first + i, "energy"));
        return most;
    };
    const double before = largest(from), later = largest(to);
    return std::log(later / before) / (2.0 * (to - from));
}

// The factor by which a step multiplies the swing, from four places, one after another: a linear step has q'' = T q' - D q.
double factorOfAStep(DemoRun& run) {
    std::array<double, 4> q{};
    for (int i = 0; i < 4; ++i) q.at(static_cast<std::size_t>(i)) = after(run, i, "place");
    const double below = q[1] * q[1] - q[0] * q[2];
    const double trace = (q[1] * q[2] - q[0] * q[3]) / below, product = (q[2] * q[2] - q[1] * q[3]) / below;
    const std::complex<double> half = trace / 2, root = std::sqrt(half * half - product);
    return std::max(std::abs(half + root), std::abs(half - root));
}

void play(const std::vector<KnobSetting>& knobs, const std::vector<TimedChange>& changes, int frame) {
    stage().open(findDemo("springs"), 240, 140);
    stage().begin(knobs, changes);
    stage().draw(frame, true);
}
double read(const std::string& name) {
    for (const Readout* readout : stage().demo().readouts()) {
        if (readout->name() == name) return readout->value().value_or(NAN);
    }
    return NAN;
}

}  // namespace

TEST(SpringsFull, limits) {
    DemoRun run("springs", 64, 64);
    for (const OdeMethod method : odeMethods) {
        run.set("method", words.at(static_cast<std::size_t>(method)));
        for (const double ratio : {0.0, 0.1, 0.5}) {
            SCOPED_TRACE(std::string(methodName(method)) + ", damping " + std::to_string(ratio));
            const double limit = limitOf(method, ratio);
            if (limit >= 10) {
                EXPECT_TRUE(isImplicit(method));
                swing(run, 16, ratio);
                // 1e-12: what Newton's method leaves in a step
                EXPECT_LT(after(run, 200, "energy"), after(run, 0, "energy") * (1 + 200 * 1e-12));
                EXPECT_EQ(run.readout("outside"), 0);
                continue;
            }
            if (limit == 0) {
                // Undamped, explicit Euler and midpoint grow however short the step: by z^2/2 and z^4/8
                EXPECT_EQ(ratio, 0);
                EXPECT_TRUE(method == OdeMethod::explicitEuler || method == OdeMethod::explicitMidpoint);
                for (const double wh : {0.3, 0.1}) {
                    swing(run, wh, 0);
                    const double expected = method == OdeMethod::explicitEuler ? wh * wh / 2 : std::pow(wh, 4) / 8;
                    EXPECT_NEAR(growth(run, 10, 300), expected, 0.1 * expected) << wh;
                    EXPECT_EQ(run.readout("outside"), 2);
                }
                continue;
            }
            // 1 % above it grows, as much as the stability function says; 1 % below nothing does, and stays so.
            const std::complex<double> direction(-ratio, std::sqrt(1 - ratio * ratio));
            for (const double part : {0.99, 1.01}) {
                swing(run, part * limit, ratio);
                // 1e-12 of each place, through differences of places that are alike to 1e-2 at the least
                const double grows = factorOfAStep(run);
                EXPECT_NEAR(grows, amplification(method, part * limit * direction), 1e-7);
                EXPECT_EQ(grows > 1 + 1e-6, part > 1) << grows;
                EXPECT_EQ(run.readout("outside"), part > 1 ? 2 : 0);
            }
            swing(run, 0.99 * limit, ratio);
            if (after(run, 300, "steps-computed") > 0) {
                EXPECT_LT(growth(run, 300, 900), 1e-4);
            }
        }
    }
    // The values that the field knows
    EXPECT_NEAR(limitOf(OdeMethod::symplecticEuler, 0), 2, 1e-3);
    EXPECT_NEAR(limitOf(OdeMethod::velocityVerlet, 0), 2, 1e-3);
    EXPECT_NEAR(limitOf(OdeMethod::rungeKutta4, 0), 2.83, 5e-3);
    EXPECT_NEAR(limitOf(OdeMethod::dormandPrince, 0), 1.0, 5e-3);
}

TEST(SpringsFull, dots_tell) {
    DemoRun run("springs", 64, 64);
    run.set("stiffness", 1e4).set("damping", 0);
    for (const char* problem : {"chain", "net", "cloth"}) {
        SCOPED_TRACE(problem);
        run.set("problem", problem);
        int first = 1;
        while (first < 100 && after(run.set("substeps", first), 1, "outside") > 0) ++first;
        ASSERT_GT(first, 2);
        // Off by more than all the energy there was; or stopped, and so no number any more
        (void)run.set("substeps", first - 1).picture(300);
        EXPECT_TRUE(!run.measured("largest-drift") || run.readout("largest-drift") > 1);
        EXPECT_LT(after(run.set("substeps", first + 1), 300, "largest-drift"), 0.01);
    }
    // Damping beyond critical: 4 N s/m and masses of 0.1 kg make real eigenvalues of -4/0.1 * 4 and more.
    run.set("problem", "chain").set("stiffness", 100).set("damping", 20);
    for (const char* method : {"symplectic-euler", "velocity-verlet"}) {
        int first = 1;
        while (first < 100 && after(run.set("method", method).set("substeps", first), 1, "outside") > 0) ++first;
        ASSERT_GT(first, 2) << method;
        (void)run.set("substeps", first - 1).picture(300);
        EXPECT_TRUE(!run.measured("largest-drift") || run.readout("largest-drift") > 1) << method << first;
        EXPECT_LT(after(run.set("substeps", first + 1), 300, "largest-drift"), 1) << method << first;
    }
}

TEST(SpringsFull, stops_in_words) {
    DemoRun run("springs", 480, 280);
    for (const char* method : {"explicit-euler", "velocity-verlet", "runge-kutta-4", "dormand-prince"}) {
        SCOPED_TRACE(method);
        run.set("method", method).set("stiffness", 1e6).set("substeps", 4);
        const Picture stopped = run.picture(300);
        ASSERT_EQ(run.messages().size(), 1U);
        const std::string said = run.messages().front();
        EXPECT_EQ(said.rfind("stopped at step ", 0), 0U) << said;
        EXPECT_NE(said.find("is not finite"), std::string::npos) << said;
        EXPECT_EQ(run.readout("steps-computed"), 0);
        EXPECT_EQ(run.picture(400), stopped);
        // The step that it names is the first that could not be: it is in the frame in which steps end.
        const int step = std::stoi(said.substr(16));
        (void)run.picture((step - 1) / 4);
        EXPECT_TRUE(run.messages().empty());
        (void)run.picture((step - 1) / 4 + 1);
        EXPECT_EQ(run.messages().size(), 1U);
    }
}

TEST(Springs, falls_asleep) {
    DemoRun run("springs", 64, 64);
    run.preset("falls-asleep");
    const double first = after(run, 0, "energy"), z = run.readout("largest-z");
    EXPECT_NEAR(z, 16.67, 0.01);
    // Each step divides the energy by 1 + z^2; 1e-9 of it is Newton's method's
    EXPECT_NEAR(after(run, 1, "energy") / first, 1 / (1 + z * z), 1e-9);
    EXPECT_NEAR(run.readout("drift"), 1 / (1 + z * z) - 1, 1e-9);
    EXPECT_LT(after(run, 3, "energy") / first, 1e-7);
    EXPECT_EQ(run.readout("dissipated"), 0);
}

TEST(Springs, phase) {
    DemoRun run("springs", 64, 64);
    run.preset("right-energy-wrong-phase");
    EXPECT_LT(after(run, 600, "largest-drift"), 1e-9);
    EXPECT_NEAR(run.readout("true-turn"), 1000 / 60.0, 1e-9);
    // The midpoint rule turns by 2 atan(w h/2)
    EXPECT_NEAR(run.readout("turn"), 2 * std::atan(1000 / 120.0), 1e-6);
    EXPECT_NEAR(run.readout("turn"), 2.9, 0.05);
    // Short steps turn as they ought to: by z^3/12 less
    run.set("stiffness", 36);
    const double turn = after(run, 100, "turn");
    EXPECT_NEAR(run.readout("true-turn") - turn, 1e-3 / 12, 1e-3 / 12 * 0.1);
}

TEST(SpringsFull, rest_lengths) {
    DemoRun run("springs", 64, 64);
    run.preset("rest-lengths");
    EXPECT_EQ(after(run, 600, "outside"), 0) << "by its eigenvalues nothing is to be feared";
    EXPECT_GT(run.readout("largest-drift"), 0.3);
    EXPECT_GT(run.readout("halved"), 10);
    EXPECT_LT(after(run.set("method", "energy-momentum"), 600, "largest-drift"), 1e-9);
    // With short steps midpoint is right, too
    EXPECT_LT(after(run.set("method", "implicit-midpoint").set("substeps", 100), 60, "largest-drift"), 0.01);
}

TEST(SpringsFull, balance) {
    const std::vector<TimedChange> played{{20, "hand-x", "0.2"}, {21, "hand-y", "0.9"}, {40, "stiffness", "5e4"},
                                          {60, "damping", "3"},  {80, "hand-x", "-1"},  {90, "stiffness", "200"},
                                          {95, "gravity", "3"},  {100, "grip", "0"},    {110, "substeps", "2"}};
    for (const char* problem : {"chain", "net", "cloth"}) {
        SCOPED_TRACE(problem);
        const std::vector<KnobSetting> knobs{{"problem", problem}, {"method", "energy-momentum"}, {"substeps", "1"}};
        play(knobs, played, 150);
        EXPECT_GT(std::abs(read("work")), 1) << "it was played";
        EXPECT_GT(read("dissipated"), 0.1);
        EXPECT_LT(read("largest-drift"), 1e-9);
        // The work is what the hand did: without it energy and dissipated are elsewhere
        play({{"problem", problem}, {"method", "energy-momentum"}}, {}, 150);
        EXPECT_EQ(read("work"), 0);
    }
    // A method of order 4 errs 16 times less by half the step, and more where energy gains an order.
    DemoRun run("springs", 64, 64);
    run.set("method", "runge-kutta-4").set("stiffness", 100).set("damping", 1);
    const double coarse = after(run.set("substeps", 8), 40, "largest-drift");
    const double fine = after(run.set("substeps", 16), 40, "largest-drift");
    EXPECT_GT(coarse / fine, 12);
    EXPECT_GT(fine, 1e-14) << "not roundings";
    stage().close();
}

// Explicit methods cost evaluations alone. The implicit ones are slower by their times: [twice-as-fast] of the study.
TEST(SpringsFull, default_is_cheapest) {
    DemoRun run("springs", 64, 64);
    const auto errs = [&](const std::string& method, int substeps) {
        (void)run.set("method", method).set("substeps", substeps).picture(300);
        return run.measured("largest-drift") ? run.readout("largest-drift") : 1e300;
    };
    const int initial = static_cast<int>(run.demo().number("substeps"));
    const std::string method = run.demo().word("method");
    EXPECT_EQ(method, "velocity-verlet");
    EXPECT_LT(errs(method, initial), 1e-3);
    // Evaluations a step: with damping Verlet has two, Dormand-Prince's seventh is the next step's first
    const std::vector<std::pair<const char*, int>> costs{{"explicit-euler", 1},  {"symplectic-euler", 1},
                                                         {"velocity-verlet", 2}, {"explicit-midpoint", 2},
                                                         {"runge-kutta-4", 4},   {"dormand-prince", 6}};
    for (const auto& [other, cost] : costs) {
        for (int substeps = 1; substeps * cost < 2 * initial; ++substeps) {
            EXPECT_GT(errs(other, substeps), 1e-3) << other << " " << substeps;
        }
    }
}

TEST(SpringsFull, rests) {
    DemoRun run("springs", 240, 140);
    for (const char* problem : {"chain", "net", "cloth"}) {
        SCOPED_TRACE(problem);
        run.set("gravity", 0).set("hand-x", 0.6).set("hand-y", -0.4).set("problem", problem);
        const Picture first = run.picture(1);
        for (const int frame : {1, 2, 100}) {
            EXPECT_EQ(run.picture(frame), first);
            EXPECT_EQ(run.readout("steps-computed"), 0);
        }
    }
    // The uploads of a frame then: the region's matrix and nothing else
    const std::vector<KnobSetting> still{{"gravity", "0"}, {"hand-x", "0.6"}, {"hand-y", "-0.4"}};
    const AuditReport report = auditDemo(stage(), findDemo("springs"), still, 50);
    EXPECT_TRUE(report.clean()) << auditText(report);
    EXPECT_LE(report.steady.bytesUploaded, 80);
    // Whoever pulls wakes it, and friction brings it to rest again.
    play({{"gravity", "0"}, {"hand-x", "0.6"}, {"hand-y", "-0.4"}, {"damping", "2"}}, {{10, "hand-x", "0.7"}}, 12);
    EXPECT_GT(read("steps-computed"), 0);
    // Along a chain without gravity all that moves is damped.
    const std::vector<KnobSetting> pulled{{"problem", "chain"}, {"gravity", "0"}, {"masses", "3"},
                                          {"stiffness", "100"}, {"damping", "5"}, {"hand-x", "0.8"},
                                          {"hand-y", "-0.6"}};
    play(pulled, {}, 20);
    EXPECT_GT(read("steps-computed"), 0);
    play(pulled, {}, 2000);
    EXPECT_EQ(read("steps-computed"), 0);
    EXPECT_GT(read("energy"), 1) << "the springs stay as long as they are";
    play(pulled, {{2000, "hand-x", "0"}}, 2001);
    EXPECT_GT(read("steps-computed"), 0);
    stage().close();
}

TEST(SpringsFull, classics) {
    DemoRun run("springs", 240, 140);
    run.set("method", "rodas");
    for (const char* problem :
         {"undamped-spring", "damped-spring", "robertson", "van-der-pol", "hires", "oregonator", "pleiades"}) {
        // A tolerance is of a step; the end may be some times that off, in the smallest component as in the largest
        EXPECT_LT(after(run.set("problem", problem), 1, "end-error"), 1e-5) << problem;
        EXPECT_TRUE(run.messages().empty());
    }
    (void)run.set("problem", "stiff-chain").picture();
    EXPECT_TRUE(run.messages().empty());
    EXPECT_FALSE(run.measured("end-error")) << "nobody has published it";
    run.set("method", "dormand-prince");
    for (const char* problem : {"robertson", "van-der-pol", "oregonator"}) {
        (void)run.set("problem", problem).picture();
        ASSERT_EQ(run.messages().size(), 1U) << problem;
        EXPECT_EQ(run.messages()[0].rfind("gave up at t = ", 0), 0U) << run.messages()[0];
        EXPECT_FALSE(run.measured("end-error"));
    }
    EXPECT_LT(after(run.set("problem", "pleiades"), 1, "end-error"), 1e-3) << "it is not stiff";
    // By equal steps Runge-Kutta 4 leaves all numbers, and says so.
    (void)run.set("method", "runge-kutta-4").set("problem", "robertson").picture();
    ASSERT_EQ(run.messages().size(), 1U);
    EXPECT_NE(run.messages()[0].find("not finite"), std::string::npos);
    EXPECT_NE(run.set("method", "velocity-verlet").refusal(), "");
    EXPECT_NE(run.set("method", "energy-momentum").refusal(), "");
}

TEST(SpringsFull, confirmed) {
    DemoRun run("springs", 240, 140);
    run.set("confirm", "on").set("method", "dormand-prince").set("problem", "pleiades").set("tolerance", "0.01");
    EXPECT_GT(after(run, 1, "end-error"), 1);
    ASSERT_EQ(run.messages().size(), 1U);
    EXPECT_EQ(run.messages()[0].rfind("by a tenth of the tolerance, at t = 3, a component differs by ", 0), 0U)
        << run.messages()[0];
    run.set("tolerance", "1e-06");
    for (const char* method : {"rodas", "radau"}) {
        run.set("method", method);
        for (const char* problem : {"undamped-spring", "damped-spring", "stiff-chain", "robertson", "van-der-pol",
                                    "hires", "oregonator", "pleiades"}) {
            (void)run.set("problem", problem).picture();
            EXPECT_TRUE(run.messages().empty()) << problem << " by " << method << ": " << run.messages()[0];
        }
    }
    // A method that gives up is not tried again
    (void)run.set("method", "dormand-prince").set("problem", "van-der-pol").picture();
    ASSERT_EQ(run.messages().size(), 1U);
    EXPECT_EQ(run.messages()[0].rfind("gave up at t = ", 0), 0U) << run.messages()[0];
}

TEST(SpringsFull, same_frame) {
    DemoRun run("springs", 240, 140);
    const Picture late = run.picture(200), early = run.picture(40);
    EXPECT_NE(late, early);
    EXPECT_EQ(run.picture(200), late);
    EXPECT_EQ(run.picture(40), early);

    // Somebody drags the hand and stiffens the springs. A copied command shows the same.
    const std::vector<KnobSetting> knobs{{"method", "bdf2"}, {"masses", "4"}};
    Picture played;
    std::vector<TimedChange> changes;
    {
        Session session(stage(), findDemo("springs"), {.width = 240, .height = 140, .knobs = knobs, .paused = true});
        for (int index = 1; index <= 90; index += 3) {
            session.playback().goTo(index);
            if (index > 20 && index < 40) (void)session.set("hand-x", numberText(0.5 - 0.02 * index));
            if (index == 61) (void)session.set("stiffness", "30000");
            session.touch();
            session.draw(240, 140, false);
        }
        played = stage().picture();
        changes = stage().timeline().changesUntil(88);
    }
    EXPECT_GT(changes.size(), 6U);
    stage().open(findDemo("springs"), 240, 140);
    stage().begin(knobs, changes);
    stage().draw(88);
    EXPECT_EQ(stage().picture(), played);
    stage().open(findDemo("springs"), 240, 140);
    stage().begin(knobs);
    stage().draw(88);
    EXPECT_NE(stage().picture(), played);
    stage().close();
}
