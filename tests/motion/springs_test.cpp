#include "mv/motion/springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/support.h"
#include "mv/motion/ode_fixed.h"

using namespace mv;
using namespace mv::test;

namespace {

using Values = std::vector<double>;

// A tetrahedron of different masses and springs, moving; `damping` of all springs.
SpringSystem tetrahedron(double damping) {
    SpringSystem system;
    for (int i = 0; i < 4; ++i) system.points.push_back({.mass = 1.0 + i});
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const double number = static_cast<double>(4 * a + b);
            system.springs.push_back(
                {.a = a, .b = b, .stiffness = 3 + number, .restLength = 0.1 * number, .damping = damping * number});
        }
    }
    return system;
}

Values randomState(std::uint64_t seed, std::size_t points) {
    Random random(seed);
    std::vector<vec3> positions, velocities;
    for (std::size_t i = 0; i < points; ++i) {
        positions.push_back(random.point(2));
        velocities.push_back(random.point(1));
    }
    return springState(positions, velocities);
}

TEST(Springs, ForcesAreTheEnergysSlope) {
    SpringSystem system = tetrahedron(0);
    system.gravity = {0, -9.81, 1};
    const Values y = randomState(1, 4);
    Values slope(24);
    springProblem(system).slope(0, y, slope);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(slope[i], y[12 + i]);
        const double h = 1e-5;
        Values before = y, after = y;
        before[i] -= h;
        after[i] += h;
        const double force = -(springEnergy(system, after) - springEnergy(system, before)) / (2 * h);
        // Central differences of energies of 100: 1e-10 of them, divided by 1e-5.
        EXPECT_NEAR(slope[12 + i] * system.points[i / 3].mass, force, 1e-6) << i;
    }
}

TEST(Springs, ForcesKeepBothMomentaAndDampingTakesEnergy) {
    for (const double damping : {0.0, 0.5}) {
        const SpringSystem system = tetrahedron(damping);
        const Values y = randomState(2, 4);
        Values slope(24);
        springProblem(system).slope(0, y, slope);
        vec3 force(0), torque(0);
        double power = 0;  // of the forces, and the change of the springs' energy beside it
        for (std::size_t p = 0; p < 4; ++p) {
            const vec3 f = system.points[p].mass * velocityOf(slope, p);
            force += f;
            torque += glm::cross(positionOf(y, p), f);
            power += glm::dot(f, velocityOf(y, p));
        }
        EXPECT_LT(glm::length(force), 1e-13);  // sums of forces of size 30
        EXPECT_LT(glm::length(torque), 1e-13);
        Values rest = y;
        std::fill(rest.begin() + 12, rest.end(), 0);
        const double h = 1e-6;
        Values moved = rest;
        for (std::size_t i = 0; i < 12; ++i) moved[i] += h * y[12 + i];
        const double change = (springEnergy(system, moved) - springEnergy(system, rest)) / h;
        // A one-sided difference is off by h times a second derivative of 100.
        EXPECT_TRUE(damping == 0 ? std::abs(power + change) < 1e-3 : power + change < -0.1) << power << " " << change;
    }
}

TEST(Springs, TheJacobianIsTheDifferencedOne) {
    for (const double damping : {0.0, 0.5}) {
        SpringSystem system = tetrahedron(damping);
        system.points[1].isFixed = true;
        Values y = randomState(3, 4);
        for (std::size_t i = 15; i < 18; ++i) y[i] = 0;
        OdeProblem problem = springProblem(system);
        problem.scale.assign(24, 1);
        Values slope(24), analytic(24 * 24);
        problem.slope(0, y, slope);
        std::int64_t evaluations = 0;
        const Values differenced = differencedJacobian(problem, 0, y, slope, 0, evaluations);
        std::vector<MatrixEntry> entries;
        problem.sparseJacobian(0, y, entries);
        for (const auto& [row, column, value] : entries) {
            analytic[24 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)] += value;
        }
        // Half of the digits of sums of numbers up to 100.
        for (std::size_t i = 0; i < analytic.size(); ++i) EXPECT_NEAR(analytic[i], differenced[i], 1e-5) << i;
    }
}

TEST(Springs, WhatIsFixedStaysAndIsNoMomentum) {
    SpringSystem system;
    system.points = {{.isFixed = true}, {.mass = 2}};
    system.springs = {{.a = 0, .b = 1, .stiffness = 50, .restLength = 1}};
    system.gravity = {0, -10, 0};
    const Values start = springState(std::vector<vec3>{{1, 2, 3}, {1, 1, 3}}, std::vector<vec3>{vec3(0), {1, 0, 0}});
    EXPECT_EQ(linearMomentum(system, start), vec3(2, 0, 0));
    EXPECT_EQ(angularMomentum(system, start), vec3(0, 6, -2));
    // Kinetic 1, the spring at rest, the height 1 of a mass of 2 under gravity 10.
    EXPECT_EQ(springEnergy(system, start), 21);
    const OdeResult end = integrateFixed(springProblem(system), OdeMethod::rodas, 0, 1, 100, start);
    EXPECT_EQ(positionOf(end.y, 0), vec3(1, 2, 3));
    EXPECT_NE(positionOf(end.y, 1), vec3(1, 1, 3));
}

TEST(Springs, TheImpossibleIsRefused) {
    const SpringSystem good = tetrahedron(1);
    const auto changed = [&](auto change) {
        SpringSystem system = good;
        change(system);
        return refusal([&] { springProblem(system); });
    };
    EXPECT_EQ(changed([](SpringSystem&) {}), "nothing was refused");
    EXPECT_EQ(changed([](SpringSystem& s) { s.points.clear(); }), "springs: there must be a point, none");
    EXPECT_EQ(changed([](SpringSystem& s) { s.points[2].mass = 0; }),
              "springs: each mass must be greater than 0 and finite, 0");
    EXPECT_EQ(changed([](SpringSystem& s) { s.springs[0].b = 4; }),
              "springs: each spring must join two of the 4 points, 1 and 4");
    EXPECT_EQ(changed([](SpringSystem& s) { s.springs[0].b = 1; }),
              "springs: each spring must join two of the 4 points, 1 and 1");
    EXPECT_EQ(changed([](SpringSystem& s) { s.springs[0].stiffness = -1; }),
              "springs: each stiffness must be 0 or more and finite, -1");
    EXPECT_EQ(changed([](SpringSystem& s) { s.springs[0].damping = infinite; }),
              "springs: each damping must be 0 or more and finite, inf");
    EXPECT_EQ(changed([](SpringSystem& s) { s.gravity.y = notANumber; }),
              "springs: gravity must be finite, (0, nan, 0)");
    const auto state = [&](auto change) {
        Values y = randomState(4, 4);
        change(y);
        return refusal([&] { requireSprings(good, y); });
    };
    EXPECT_EQ(state([](Values&) {}), "nothing was refused");
    EXPECT_EQ(state([](Values& y) { y.pop_back(); }),
              "springs: the state of 4 points must have six numbers for each, 23");
    EXPECT_EQ(state([](Values& y) { y[5] = notANumber; }), "springs: each number of the state must be finite, nan");
    EXPECT_EQ(state([](Values& y) { std::fill(y.begin(), y.end(), 1); }),
              "springs: the ends of a spring with a rest length or damping must be in two places, (1, 1, 1)");
    EXPECT_EQ(refusal([] { springState(std::vector<vec3>(2), std::vector<vec3>(1)); }),
              "springs: there must be a velocity for each of the 2 points, 1");
}

}  // namespace
