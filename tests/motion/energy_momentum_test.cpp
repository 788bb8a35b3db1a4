#include "mv/motion/energy_momentum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "math/support.h"
#include "mv/motion/ode_adaptive.h"

using namespace mv;
using namespace mv::test;

namespace {

using Values = std::vector<double>;

// Three masses in a ring, thrown apart and turning, with rest lengths: the strain of a tenth of their length.
SpringSystem ring(double stiffness, double damping = 0) {
    SpringSystem system;
    system.points = {{.mass = 1}, {.mass = 2}, {.mass = 3}};
    for (std::size_t i = 0; i < 3; ++i) {
        system.springs.push_back(
            {.a = i, .b = (i + 1) % 3, .stiffness = stiffness, .restLength = 1, .damping = damping});
    }
    return system;
}

const Values thrown = springState(std::vector<vec3>{{0, 0, 0}, {1.1, 0, 0}, {0.4, 0.95, 0.1}},
                                  std::vector<vec3>{{0, 1, 0}, {0.5, 0, 1}, {-1, 0, 0.2}});

struct Drift {
    double energy = 0, linear = 0, angular = 0;  // as parts of their first values
    std::int64_t steps = 0;
};

template <typename Stepper>
Drift drift(const SpringSystem& system, Stepper& stepper, int steps) {
    const double energy = springEnergy(system, thrown);
    const vec3 linear = linearMomentum(system, thrown), angular = angularMomentum(system, thrown);
    Drift result;
    while (result.steps < steps && stepper.step()) {
        ++result.steps;
        const auto y = stepper.state();
        result.energy = std::max(result.energy, std::abs(springEnergy(system, y) / energy - 1));
        result.linear = std::max(result.linear, glm::length(linearMomentum(system, y) - linear) / glm::length(linear));
        result.angular =
            std::max(result.angular, glm::length(angularMomentum(system, y) - angular) / glm::length(angular));
    }
    return result;
}

constexpr double frame = 1.0 / 60;

TEST(EnergyMomentum, KeepsEnergyAndMomentaHoweverStiff) {
    for (const double stiffness : {1.0, 1e3, 1e6}) {
        SCOPED_TRACE(stiffness);
        const SpringSystem system = ring(stiffness);
        EnergyMomentumStepper stepper(system, 0, frame, thrown);
        const Drift kept = drift(system, stepper, 600);
        EXPECT_EQ(stepper.failure(), "");
        EXPECT_EQ(kept.steps, 600);
        // 600 steps, in halves of halves where they are stiff, each with what Newton's method leaves: 1e-14 of a
        // length in a move, times 2/h, 1e3, in a velocity, in one direction at worst.
        EXPECT_LT(kept.energy, 1e-9);
        EXPECT_LT(kept.linear, 1e-9);
        EXPECT_LT(kept.angular, 1e-9);
    }
}

TEST(EnergyMomentum, WhereTheMidpointRuleDoesNot) {
    const SpringSystem system = ring(1e6);
    // Its halving taken away, or it would change to short steps where it fails.
    FixedStepper midpoint(springProblem(system), OdeMethod::implicitMidpoint, 0, frame, thrown, {.mostHalvings = 0});
    const Drift run = drift(system, midpoint, 600);
    EXPECT_TRUE(run.steps < 600 || run.energy > 0.1) << run.steps << " " << run.energy;
    FixedStepper halved(springProblem(system), OdeMethod::implicitMidpoint, 0, frame, thrown);
    const Drift halves = drift(system, halved, 600);
    EXPECT_TRUE(halves.steps < 600 || halves.energy > 1e-3) << halves.steps << " " << halves.energy;
}

TEST(EnergyMomentum, IsOfOrder2) {
    const SpringSystem system = ring(30, 0.5);
    const Values exact = integrateAdaptive(springProblem(system), OdeMethod::dormandPrince, 0, 1, thrown,
                                           {.relative = 1e-13, .absolute = 1e-14})
                             .y;
    const auto error = [&](int steps) {
        EnergyMomentumStepper stepper(system, 0, 1.0 / steps, thrown);
        for (int i = 0; i < steps; ++i) EXPECT_TRUE(stepper.step());
        double worst = 0;
        for (std::size_t i = 0; i < exact.size(); ++i) worst = std::max(worst, std::abs(stepper.state()[i] - exact[i]));
        return worst;
    };
    EXPECT_NEAR(std::log2(error(200) / error(400)), 2, 0.05);
}

TEST(EnergyMomentum, WhatDampingTakesIsCounted) {
    for (const double damping : {1e-2, 1.0, 1e3}) {
        SCOPED_TRACE(damping);
        const SpringSystem system = ring(1e6, damping);
        EnergyMomentumStepper stepper(system, 0, frame, thrown);
        const double energy = springEnergy(system, thrown);
        double before = 0;
        for (int i = 0; i < 300; ++i) {
            ASSERT_TRUE(stepper.step()) << stepper.failure();
            EXPECT_GE(stepper.dissipated(), before);
            before = stepper.dissipated();
            EXPECT_NEAR((springEnergy(system, stepper.state()) + before) / energy, 1, 1e-9);  // as without damping
        }
        EXPECT_GT(before, 1e-3 * energy);
    }
}

TEST(EnergyMomentum, IsTheMidpointRuleWithoutRestLengths) {
    SpringSystem system = ring(1e6);
    for (Spring& spring : system.springs) spring.restLength = 0;
    EnergyMomentumStepper stepper(system, 0, frame, thrown);
    FixedStepper midpoint(springProblem(system), OdeMethod::implicitMidpoint, 0, frame, thrown);
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(stepper.step() && midpoint.step());
    // Velocities of 2000; roundings that 50 steps of a factor 16.7 in the matrix spread.
    for (std::size_t i = 0; i < thrown.size(); ++i) EXPECT_NEAR(stepper.state()[i], midpoint.state()[i], 1e-8) << i;
    EXPECT_EQ(stepper.counts().factorizations, 1);
}

TEST(EnergyMomentum, GravityAndFixedPointsKeepTheEnergy) {
    SpringSystem system;
    system.points = {{.isFixed = true}, {.mass = 0.1}, {.mass = 0.1}, {.mass = 2}};
    for (std::size_t i = 0; i < 3; ++i) {
        system.springs.push_back({.a = i, .b = i + 1, .stiffness = 1e5, .restLength = 0.5});
    }
    system.gravity = {0, -9.81, 0};
    const Values start = springState(std::vector<vec3>{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1.5, 0, 0}},
                                     std::vector<vec3>{vec3(0), vec3(0), vec3(0), {0, 0, 1}});
    EnergyMomentumStepper stepper(system, 0, frame, start);
    const double energy = springEnergy(system, start);
    for (int i = 0; i < 600; ++i) {
        ASSERT_TRUE(stepper.step()) << stepper.failure();
        EXPECT_EQ(positionOf(stepper.state(), 0), vec3(0));
        // The energies that are exchanged are 30, of height; the first one is 1.
        EXPECT_NEAR(springEnergy(system, stepper.state()), energy, 30 * 1e-9);
    }
    EXPECT_LT(positionOf(stepper.state(), 3).y, 0.1);
}

TEST(EnergyMomentum, RestCostsAnIterationOrTwoAStep) {
    const SpringSystem system = ring(1e6);
    const Values still =
        springState(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}, std::vector<vec3>(3, vec3(0)));
    EnergyMomentumStepper stepper(system, 0, frame, still);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(stepper.step());
    EXPECT_LE(stepper.counts().newtonIterations, 20);
    // sqrt(0.75)^2 is rounded: a strain of 1e-16, of which k h^2 = 278 makes 3e-14 a step at most, there and back.
    for (std::size_t i = 0; i < still.size() / 2; ++i) EXPECT_NEAR(stepper.state()[i], still[i], 1e-13);
}

TEST(EnergyMomentum, GivesUpInWordsAtItsLastState) {
    // Two masses without a direction to push each other in: they meet at the middle of the first step.
    SpringSystem system;
    system.points = {{}, {}};
    system.springs = {{.a = 0, .b = 1, .stiffness = 1e-3, .restLength = 1e300}};
    const Values start = springState(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}}, std::vector<vec3>{{1, 0, 0}, {-1, 0, 0}});
    EnergyMomentumStepper stepper(system, 0, 1, start);
    while (stepper.step()) ASSERT_LT(stepper.index(), 100);
    EXPECT_EQ(stepper.failure().substr(0, 16), "gave up at t = 0") << stepper.failure();
    EXPECT_TRUE(allFinite(stepper.state()));
    EXPECT_FALSE(stepper.step());
}

TEST(EnergyMomentum, TheImpossibleIsRefused) {
    const SpringSystem system = ring(1);
    const auto why = [&](double step, const FixedOptions& options = {}) {
        return refusal([&] { EnergyMomentumStepper(system, 0, step, thrown, options); });
    };
    EXPECT_EQ(why(0), "energy-momentum: the step must be greater than 0 and finite, 0");
    EXPECT_EQ(why(1, {.newtonTolerance = 1}), "energy-momentum: newtonTolerance must be 1e-13 to 0.001, 1");
    EXPECT_EQ(refusal([&] { EnergyMomentumStepper(system, 0, 1, Values(18)); }),
              "springs: the ends of a spring with a rest length or damping must be in two places, (0, 0, 0)");
}

}  // namespace
