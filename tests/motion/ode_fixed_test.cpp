#include "mv/motion/ode_fixed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "math/support.h"
#include "mv/motion/ode_adaptive.h"
#include "mv/motion/ode_problems.h"

using namespace mv;
using namespace mv::test;

namespace {

using Values = std::vector<double>;

// A driven pendulum with friction: it reads q, v and t, and is not linear.
OdeProblem pendulum() {
    return {.dimension = 2,
            .slope =
                [](double t, std::span<const double> y, std::span<double> dydt) {
                    dydt[0] = y[1];
                    dydt[1] = -std::sin(y[0]) - 0.3 * y[1] + 0.5 * std::cos(t);
                },
            .isMechanical = true};
}

double energyOf(std::span<const double> y, double w) { return (w * w * y[0] * y[0] + y[1] * y[1]) / 2; }

TEST(OdeFixed, EachMethodHasItsOrder) {
    const Values start{1, 0.5};
    const Values exact =
        integrateAdaptive(pendulum(), OdeMethod::dormandPrince, 0, 4, start, {.relative = 1e-13, .absolute = 1e-14}).y;
    for (const OdeMethod method : odeMethods) {
        SCOPED_TRACE(methodName(method));
        const auto error = [&](int steps) {
            const OdeResult result = integrateFixed(pendulum(), method, 0, 4, steps, start);
            EXPECT_EQ(result.failure, "");
            EXPECT_EQ(result.t, 4);
            return std::hypot(result.y[0] - exact[0], result.y[1] - exact[1]);
        };
        // Halving the step again halves what bends the slope; order 5 comes near to the reference's 1e-13 beyond.
        const int steps = methodOrder(method) >= 4 ? 80 : 640;
        EXPECT_NEAR(std::log2(error(steps) / error(2 * steps)), methodOrder(method), 0.15);
    }
}

TEST(OdeFixed, TheTimeIsAProduct) {
    const OdeProblem clock{.dimension = 1,
                           .slope = [](double, std::span<const double>, std::span<double> dydt) { dydt[0] = 1; }};
    FixedStepper stepper(clock, OdeMethod::explicitEuler, 10, 0.1, {0});
    for (int i = 1; i <= 100000; ++i) {
        ASSERT_TRUE(stepper.step());
        ASSERT_EQ(stepper.time(), 10 + i * 0.1);
    }
    EXPECT_EQ(stepper.index(), 100000);
}

// Its R(iy) has the absolute value 1: q and v are turned, by 2 atan(8.35) = 2.9 rad instead of 16.7, which is its
// wrong phase.
TEST(OdeFixed, ImplicitMidpointKeepsQuadraticEnergy) {
    const double w = 1000, h = 1.0 / 60;
    FixedStepper stepper(springCase(w, 0).problem, OdeMethod::implicitMidpoint, 0, h, {1, 0});
    ASSERT_TRUE(stepper.step());
    EXPECT_NEAR(std::atan2(-stepper.state()[1] / w, stepper.state()[0]), 2 * std::atan(w * h / 2), 1e-12);
    for (int i = 1; i < 100000; ++i) {
        ASSERT_TRUE(stepper.step());
        // 1e5 steps that are off by some roundings each, in whatever direction: their sum at worst.
        ASSERT_NEAR(energyOf(stepper.state(), w) / energyOf(Values{1, 0}, w), 1, 1e-9) << i;
    }
    // A linear problem has one matrix. The second of two iterations finds nothing more to correct.
    EXPECT_EQ(stepper.counts().jacobians, 1);
    EXPECT_EQ(stepper.counts().factorizations, 1);
    EXPECT_EQ(stepper.counts().newtonIterations, 200000);
    EXPECT_EQ(stepper.counts().accepted, 100000);
    EXPECT_EQ(stepper.counts().rejected, 0);
}

TEST(OdeFixed, SymplecticMethodsKeepTheEnergyNearAndOthersDoNot) {
    const auto spread = [](OdeMethod method) {
        FixedStepper stepper(springCase(1, 0).problem, method, 0, 0.1, {1, 0});
        double worst = 0;
        for (int i = 0; i < 100000 && stepper.step(); ++i) {
            worst = std::max(worst, std::abs(energyOf(stepper.state(), 1) / 0.5 - 1));
        }
        return worst;
    };
    EXPECT_LT(spread(OdeMethod::symplecticEuler), 0.12);  // wh and more, for ever
    EXPECT_LT(spread(OdeMethod::velocityVerlet), 0.003);  // (wh)^2/4
    EXPECT_GT(spread(OdeMethod::rungeKutta4), 0.001);     // each step loses (wh)^6/72, and 1e5 of them 0.0014
    EXPECT_GT(spread(OdeMethod::implicitEuler), 0.999);   // asleep
}

// The state falls by 1/16.7 a step, so to the smallest doubles in 260 of them.
TEST(OdeFixed, WhatDiesAwayDoesNotFail) {
    for (const OdeMethod method : {OdeMethod::implicitEuler, OdeMethod::bdf2, OdeMethod::rodas, OdeMethod::radau}) {
        FixedStepper stepper(springCase(1000, 0).problem, method, 0, 1.0 / 60, {1, 0});
        for (int i = 0; i < 2000; ++i) ASSERT_TRUE(stepper.step()) << stepper.failure();
        EXPECT_LT(std::abs(stepper.state()[0]), 1e-100) << methodName(method);
    }
}

TEST(OdeFixed, EvaluationsAreCounted) {
    for (const OdeMethod method : odeMethods) {
        SCOPED_TRACE(methodName(method));
        std::int64_t evaluations = 0;
        OdeProblem problem = pendulum();
        problem.slope = [&, slope = problem.slope](double t, std::span<const double> y, std::span<double> dydt) {
            ++evaluations;
            slope(t, y, dydt);
        };
        const OdeResult result = integrateFixed(problem, method, 0, 1, 50, {1, 0});
        EXPECT_EQ(result.counts.evaluations, evaluations);
        EXPECT_EQ(result.counts.accepted, 50);
        EXPECT_EQ(result.counts.rejected, 0);
        const auto perStep = [&](std::int64_t stages) { EXPECT_EQ(evaluations, 50 * stages); };
        if (method == OdeMethod::explicitEuler || method == OdeMethod::symplecticEuler) perStep(1);
        if (method == OdeMethod::explicitMidpoint || method == OdeMethod::velocityVerlet) perStep(2);
        if (method == OdeMethod::rungeKutta4) perStep(4);
        if (method == OdeMethod::dormandPrince) {
            EXPECT_EQ(evaluations, 50 * 6 + 1);
        }
        if (method == OdeMethod::rodas) perStep(6 + 1 + 2);  // and df/dt, and two columns of the Jacobian
    }
    // Verlet's one evaluation a step, where the acceleration does not read v.
    const OdeCounts free = integrateFixed(springCase(1, 0).problem, OdeMethod::velocityVerlet, 0, 1, 50, {1, 0}).counts;
    EXPECT_EQ(free.evaluations, 51);
}

TEST(OdeFixed, CopiesGoOnWithTheSameBits) {
    for (const OdeMethod method : odeMethods) {
        SCOPED_TRACE(methodName(method));
        FixedStepper stepper(pendulum(), method, 0, 0.2, {1, 0});
        for (int i = 0; i < 5; ++i) ASSERT_TRUE(stepper.step());
        FixedStepper copy = stepper;
        for (int i = 0; i < 20; ++i) ASSERT_TRUE(stepper.step());
        FixedStepper assigned(springCase(1, 0).problem, method, 0, 1, {0, 0});
        assigned = copy;
        for (int i = 0; i < 20; ++i) ASSERT_TRUE(copy.step() && assigned.step());
        EXPECT_EQ(Values(copy.state().begin(), copy.state().end()),
                  Values(stepper.state().begin(), stepper.state().end()));
        EXPECT_EQ(Values(assigned.state().begin(), assigned.state().end()),
                  Values(stepper.state().begin(), stepper.state().end()));
        EXPECT_EQ(copy.counts(), stepper.counts());
        const FixedStepper moved = std::move(copy);
        EXPECT_EQ(moved.index(), 25);
    }
}

TEST(OdeFixed, ADenseAndASparseJacobianAreOne) {
    OdeProblem sparse = springCase(3, 0.2).problem;
    sparse.jacobian = {};
    sparse.sparseJacobian = [](double, std::span<const double>, std::vector<MatrixEntry>& entries) {
        // -9 in two parts, which are summed.
        entries.assign({{0, 1, 1}, {1, 0, -4}, {1, 0, -5}, {1, 1, -2 * 0.2 * 3}});
    };
    OdeProblem differenced = sparse;
    differenced.sparseJacobian = {};
    for (const OdeMethod method : {OdeMethod::implicitEuler, OdeMethod::bdf2, OdeMethod::rodas, OdeMethod::radau}) {
        const auto end = [&](const OdeProblem& problem) { return integrateFixed(problem, method, 0, 3, 30, {1, 0}).y; };
        const Values dense = end(springCase(3, 0.2).problem);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(end(sparse)[i], dense[i], 1e-13);      // other roundings
            EXPECT_NEAR(end(differenced)[i], dense[i], 1e-7);  // half of the digits, of RODAS's own matrix
        }
    }
    sparse.sparseJacobian = [](double, std::span<const double>, std::vector<MatrixEntry>& entries) {
        entries.push_back({2, 0, 1});
    };
    EXPECT_EQ(refusal([&] {
                  integrateFixed(sparse, OdeMethod::bdf2, 0, 1, 1, {1, 0});
              }),
              "sparseJacobian: rows and columns must be 0 to 1, (2, 0)");
}

TEST(OdeFixed, WhatBlowsUpStopsAtItsLastFiniteState) {
    for (const OdeMethod method : {OdeMethod::explicitEuler, OdeMethod::symplecticEuler, OdeMethod::velocityVerlet,
                                   OdeMethod::explicitMidpoint, OdeMethod::rungeKutta4, OdeMethod::dormandPrince}) {
        SCOPED_TRACE(methodName(method));
        const double h = 1.0 / 60;
        FixedStepper stepper(springCase(1000, 0).problem, method, 0, h, {1, 0});
        while (stepper.step()) ASSERT_LT(stepper.index(), 1000);
        EXPECT_TRUE(allFinite(stepper.state()));
        const std::string step = std::to_string(stepper.index() + 1);
        EXPECT_EQ(stepper.failure().substr(0, stepper.failure().find(", because")),
                  "gave up at t = " + numberText(static_cast<double>(stepper.index()) * h) + ": no step " + step +
                      " by " + std::string(methodName(method)));
        EXPECT_NE(stepper.failure().find("not finite"), std::string::npos);
        // The error grows by 16.7 (explicit Euler) to 3e4 (Dormand-Prince) each step, to 1e308.
        EXPECT_GT(std::abs(stepper.state()[0]), 1e270);
        const Values before(stepper.state().begin(), stepper.state().end());
        EXPECT_FALSE(stepper.step());
        EXPECT_EQ(before, Values(stepper.state().begin(), stepper.state().end()));
    }
}

TEST(OdeFixed, NewtonsMethodFindsNoRootOfAnotherBranch) {
    // |y| stays below 2.0001 on the true path; steps of 1e-3 are 1000 times as long as its fast parts.
    const OdeCase ode = vanDerPolCase(1e-6);
    for (const OdeMethod method : {OdeMethod::implicitEuler, OdeMethod::implicitMidpoint, OdeMethod::bdf2}) {
        for (const int steps : {20, 200, 2000, 20000}) {
            SCOPED_TRACE(std::string(methodName(method)) + ", " + std::to_string(steps));
            FixedStepper stepper(ode.problem, method, 0, 2.0 / steps, ode.initial);
            double largest = 0;
            while (stepper.index() < steps && stepper.step()) largest = std::max(largest, std::abs(stepper.state()[0]));
            // The midpoint rule does not damp: it swings about the slow path, no further than that is from 0.
            EXPECT_LT(largest, method == OdeMethod::implicitMidpoint ? 4.1 : 2.02);
            if (stepper.failure().empty()) continue;
            EXPECT_NE(stepper.failure().find("because"), std::string::npos);
        }
    }
}

TEST(OdeFixed, AStepThatFailsIsHalvedOrRefused) {
    // Y = y + h Y^2 has a root where h y <= 1/4 alone.
    const OdeProblem pole{.dimension = 1, .slope = [](double, std::span<const double> y, std::span<double> dydt) {
                              dydt[0] = y[0] * y[0];
                          }};
    FixedStepper halving(pole, OdeMethod::implicitEuler, 0, 0.5, {1});
    EXPECT_TRUE(halving.step());
    EXPECT_GT(halving.counts().rejected, 0);
    EXPECT_EQ(halving.counts().accepted,
              halving.counts().rejected + 1);  // of a tree in which each that fails has two halves
    EXPECT_NEAR(halving.state()[0], 2, 1);     // 1/(1 - t)
    EXPECT_FALSE(halving.step() && halving.step());
    EXPECT_LE(halving.time(), 1);
    EXPECT_NE(halving.failure().find("Newton's method"), std::string::npos) << halving.failure();
    EXPECT_TRUE(allFinite(halving.state()));
    EXPECT_GT(halving.state()[0], 0);

    FixedStepper whole(pole, OdeMethod::implicitEuler, 0, 0.5, {1}, {.mostHalvings = 0});
    EXPECT_FALSE(whole.step());
    EXPECT_EQ(whole.state()[0], 1);
    EXPECT_EQ(whole.counts().rejected, 1);
    EXPECT_EQ(whole.counts().accepted, 0);
}

// BDF2 is exact for t^2, whatever the ratio of its steps, if it takes that ratio into account.
TEST(OdeFixed, Bdf2sHalvesKnowHowFarTheStateBeforeIs) {
    bool isAsked = false;
    const double h = 0.125;
    const OdeProblem parabola{.dimension = 1,
                              .slope = [&](double t, std::span<const double> y, std::span<double> dydt) {
                                  // The error of the first step dies away, by 1000 h a step.
                                  dydt[0] = 2 * t - 1000 * (y[0] - t * t);
                                  // The first attempt at step 30 fails, and its half does not.
                                  if (t == 30 * h && !isAsked) {
                                      isAsked = true;
                                      dydt[0] = notANumber;
                                  }
                              }};
    FixedStepper stepper(parabola, OdeMethod::bdf2, 0, h, {0});
    for (int i = 0; i < 30; ++i) ASSERT_TRUE(stepper.step());
    EXPECT_EQ(stepper.counts().rejected, 1);
    EXPECT_EQ(stepper.counts().accepted, 31);
    // Newton's method leaves 1e-12 of 14; taken for equal steps, the ratio would make 1e-5 of it.
    EXPECT_NEAR(stepper.state()[0], 900 * h * h, 1e-10);
}

TEST(OdeFixed, TheImpossibleIsRefused) {
    const OdeProblem problem = springCase(1, 0).problem;
    const auto why = [&](OdeMethod method, double start, double step, const FixedOptions& options = {}) {
        return refusal([&] { FixedStepper(problem, method, start, step, {1, 0}, options); });
    };
    EXPECT_EQ(why(OdeMethod::bdf2, 0, 0), "BDF2: the step must be greater than 0 and finite, 0");
    EXPECT_EQ(why(OdeMethod::bdf2, 0, notANumber), "BDF2: the step must be greater than 0 and finite, nan");
    EXPECT_EQ(why(OdeMethod::bdf2, 1e20, 1), "BDF2: the step must be longer than the rounding of the start, 1");
    EXPECT_EQ(why(OdeMethod::bdf2, infinite, 1), "BDF2: t must be finite, inf");
    EXPECT_EQ(why(OdeMethod::bdf2, 0, 1, {.newtonTolerance = 1e-14}),
              "BDF2: newtonTolerance must be 1e-13 to 0.001, 1e-14");
    EXPECT_EQ(why(OdeMethod::bdf2, 0, 1, {.mostHalvings = 41}), "BDF2: mostHalvings must be 0 to 40, 41");
    const OdeProblem first = robertsonCase().problem;
    EXPECT_EQ(refusal([&] {
                  FixedStepper(first, OdeMethod::velocityVerlet, 0, 1, {1, 0, 0});
              }),
              "velocity Verlet: must have a mechanical problem, of positions and velocities");
    EXPECT_EQ(refusal([&] {
                  integrateFixed(problem, OdeMethod::bdf2, 0, 1, 0, {1, 0});
              }),
              "BDF2: there must be at least one step, 0");
    EXPECT_EQ(refusal([&] {
                  integrateFixed(problem, OdeMethod::bdf2, 0, 0, 1, {1, 0});
              }),
              "BDF2: end must be after start, 0");
}

}  // namespace
