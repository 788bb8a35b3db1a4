#include "mv/motion/spring_stepper.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

using Values = std::vector<double>;

// A damped triangle that is thrown, in space.
SpringSystem triangle(double damping) {
    SpringSystem system;
    system.points = {{.mass = 1}, {.mass = 2}, {.mass = 3}};
    for (std::size_t i = 0; i < 3; ++i) {
        system.springs.push_back({.a = i, .b = (i + 1) % 3, .stiffness = 40, .restLength = 1, .damping = damping});
    }
    system.gravity = {0, -9.81, 0};
    return system;
}
const Values thrown = springState(std::vector<vec3>{{0, 0, 0}, {1.3, 0, 0}, {0.4, 0.95, 0.1}},
                                  std::vector<vec3>{{0, 1, 0}, {0.5, 0, 1}, {-1, 0, 0.2}});

double balanceOff(SpringStepper stepper, const SpringSystem& system, int steps) {
    for (int i = 0; i < steps; ++i) EXPECT_TRUE(stepper.step());
    return std::abs(springEnergy(system, stepper.state()) + stepper.dissipated() - springEnergy(system, thrown));
}

TEST(SpringStepper, EnergyAndWhatDampingTookStayByEachMethodsOrder) {
    const SpringSystem system = triangle(2);
    EXPECT_GT(springEnergy(system, thrown), 2);
    for (const OdeMethod method : odeMethods) {
        const double coarse = balanceOff(SpringStepper(system, method, 0, 1.0 / 200, thrown), system, 200);
        const double fine = balanceOff(SpringStepper(system, method, 0, 1.0 / 400, thrown), system, 400);
        const double order = std::log2(coarse / fine);
        // Symplectic Euler and Verlet are told the velocity a half step late, or by Euler: with damping in d, too.
        EXPECT_GT(order, methodOrder(method) - 0.35) << methodName(method) << " " << coarse << " " << fine;
    }
    // Energy-momentum keeps it to what Newton's method leaves.
    EXPECT_LT(balanceOff(SpringStepper(system, 0, 1.0 / 60, thrown), system, 60), 1e-10);
}

TEST(SpringStepper, WithoutDampingItIsTheFixedStepper) {
    const SpringSystem system = triangle(0);
    for (const OdeMethod method : odeMethods) {
        SpringStepper stepper(system, method, 0, 1.0 / 60, thrown);
        FixedStepper plain(springProblem(system), method, 0, 1.0 / 60, thrown);
        for (int i = 0; i < 20; ++i) EXPECT_EQ(stepper.step(), plain.step());
        EXPECT_EQ(stepper.state(), Values(plain.state().begin(), plain.state().end()));
        EXPECT_EQ(stepper.dissipated(), 0);
        EXPECT_EQ(stepper.counts(), plain.counts());
        EXPECT_EQ(stepper.index(), 20);
        EXPECT_EQ(stepper.time(), plain.time());
    }
}

TEST(SpringStepper, DampingChangesNothingButByItself) {
    // As stiff as damping of 1e-300 makes it: the same motion, with two unknowns more
    const SpringSystem none = triangle(0), some = triangle(1e-300);
    for (const OdeMethod method : odeMethods) {
        SpringStepper a(none, method, 0, 1.0 / 60, thrown), b(some, method, 0, 1.0 / 60, thrown);
        for (int i = 0; i < 60; ++i) {
            ASSERT_TRUE(a.step());
            ASSERT_TRUE(b.step());
        }
        // 1e-12 of Newton's method in each of 60 steps, or roundings
        for (std::size_t i = 0; i < thrown.size(); ++i) EXPECT_NEAR(a.state()[i], b.state()[i], 1e-9);
        EXPECT_NEAR(b.dissipated(), 0, 1e-290);
    }
}

TEST(SpringStepper, TheJacobianIsTheDifferencedOne) {
    OdeProblem problem = dissipatingProblem(triangle(2));
    problem.scale.assign(20, 1);
    Values y = thrown;
    y.insert(y.begin() + 9, 0.3);
    y.push_back(0.7);
    Values slope(20), analytic(400);
    problem.slope(0, y, slope);
    std::int64_t evaluations = 0;
    const Values differenced = differencedJacobian(problem, 0, y, slope, 0, evaluations);
    std::vector<MatrixEntry> entries;
    problem.sparseJacobian(0, y, entries);
    for (const auto& [row, column, value] : entries) {
        analytic[20 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)] += value;
    }
    // Half of the digits of numbers up to 100
    for (std::size_t i = 0; i < analytic.size(); ++i) EXPECT_NEAR(analytic[i], differenced[i], 1e-5) << i;
    EXPECT_EQ(slope[9], 0.7);
    EXPECT_GT(slope[19], 0);
}

TEST(SpringStepper, StopsInWordsAndCopiesGoOnAlike) {
    SpringSystem stiff = triangle(0);
    for (Spring& spring : stiff.springs) spring.stiffness = 1e6;
    SpringStepper stepper(stiff, OdeMethod::rungeKutta4, 0, 1.0 / 60, thrown);
    while (stepper.step()) ASSERT_LT(stepper.index(), 10000);
    EXPECT_NE(stepper.failure().find("gave up at t = "), std::string::npos);
    EXPECT_TRUE(allFinite(stepper.state()));
    const Values last = stepper.state();
    EXPECT_FALSE(stepper.step());
    EXPECT_EQ(stepper.state(), last);

    SpringStepper one(triangle(2), OdeMethod::bdf2, 0, 1.0 / 60, thrown);
    for (int i = 0; i < 10; ++i) one.step();
    SpringStepper other = one;
    for (int i = 0; i < 10; ++i) EXPECT_EQ(one.step(), other.step());
    EXPECT_EQ(one.state(), other.state());
    EXPECT_EQ(one.dissipated(), other.dissipated());
    EXPECT_THROW(SpringStepper(triangle(0), 0, 0, thrown), Error);
    EXPECT_THROW(SpringStepper(triangle(0), OdeMethod::rodas, 0, 0.1, {1, 2}), Error);
}

}  // namespace
