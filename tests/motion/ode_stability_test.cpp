#include "mv/motion/ode_stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "math/support.h"
#include "mv/motion/ode_fixed.h"
#include "mv/motion/ode_problems.h"
#include "mv/motion/springs.h"

using namespace mv;
using namespace mv::test;

namespace {

using Complex = std::complex<double>;

bool hasOneFactor(OdeMethod method) { return !needsMechanical(method) && method != OdeMethod::bdf2; }

// y' = z y as two real equations: a step of length 1 multiplies by R(z).
OdeProblem complexProblem(Complex z) {
    return {.dimension = 2,
            .slope =
                [z](double, std::span<const double> y, std::span<double> dydt) {
                    const Complex slope = z * Complex(y[0], y[1]);
                    dydt[0] = slope.real();
                    dydt[1] = slope.imag();
                },
            .jacobian =
                [z](double, std::span<const double>, std::span<double> j) {
                    j[0] = j[3] = z.real();
                    j[1] = -z.imag();
                    j[2] = z.imag();
                }};
}

// The oscillator that has the eigenvalues z and its conjugate.
OdeProblem oscillator(Complex z) {
    return {.dimension = 2,
            .slope =
                [z](double, std::span<const double> y, std::span<double> dydt) {
                    dydt[0] = y[1];
                    dydt[1] = -std::norm(z) * y[0] + 2 * z.real() * y[1];
                },
            .isMechanical = true};
}

TEST(OdeStability, IsWhatAStepDoes) {
    Random random(1);
    for (const OdeMethod method : odeMethods) {
        if (!hasOneFactor(method)) continue;
        SCOPED_TRACE(methodName(method));
        for (int i = 0; i < 50; ++i) {
            const Complex z(random.number(-4, 1), random.number(-4, 4));
            FixedStepper stepper(complexProblem(z), method, 0, 1, {0.6, -0.8});
            // Near a pole Newton's method has nothing to find.
            if (!stepper.step()) continue;
            const Complex got(stepper.state()[0], stepper.state()[1]),
                expected = stabilityFunction(method, z) * Complex(0.6, -0.8);
            // Some roundings of the stages, which are up to 6^6/600 large; Newton's method is right to 1e-12.
            EXPECT_LT(std::abs(got - expected), 1e-11 * std::max(1.0, std::abs(expected))) << z;
        }
    }
}

// Eigenvalues of the matrix that two steps from (1, 0) and (0, 1) make.
TEST(OdeStability, OfMechanicalMethodsIsTheStepsEigenvalue) {
    Random random(2);
    for (const OdeMethod method : {OdeMethod::symplecticEuler, OdeMethod::velocityVerlet}) {
        for (int i = 0; i < 50; ++i) {
            const Complex z(random.number(-2, 0.5), random.number(-3, 3));
            std::array<std::array<double, 2>, 2> columns{};
            for (std::size_t column = 0; column < 2; ++column) {
                FixedStepper stepper(oscillator(z), method, 0, 1, {column == 0 ? 1.0 : 0.0, column == 1 ? 1.0 : 0.0});
                ASSERT_TRUE(stepper.step());
                columns[column] = {stepper.state()[0], stepper.state()[1]};
            }
            const double trace = columns[0][0] + columns[1][1];
            const double determinant = columns[0][0] * columns[1][1] - columns[0][1] * columns[1][0];
            const Complex root = std::sqrt(Complex(trace * trace / 4 - determinant));
            const double expected = std::max(std::abs(trace / 2 + root), std::abs(trace / 2 - root));
            // A root of what is 1e-15 off and may be small.
            EXPECT_NEAR(amplification(method, z), expected, 1e-7 * std::max(1.0, expected)) << z;
        }
    }
}

TEST(OdeStability, OfBdf2IsTheGrowthOfManySteps) {
    for (const double wh : {0.2, 1.0, 5.0}) {
        const double expected = amplification(OdeMethod::bdf2, {0, wh});
        FixedStepper stepper(complexProblem({0, wh}), OdeMethod::bdf2, 0, 1, {1, 0});
        const auto size = [&] { return std::hypot(stepper.state()[0], stepper.state()[1]); };
        for (int i = 0; i < 40; ++i) ASSERT_TRUE(stepper.step());
        const double before = size();
        for (int i = 0; i < 10; ++i) ASSERT_TRUE(stepper.step());
        // After 40 steps the smaller root, at most 0.6 of the larger, has a part of 1e-8 left.
        EXPECT_NEAR(std::pow(size() / before, 0.1), expected, 1e-7);
    }
}

TEST(OdeStability, AgreesWithTheExponentialToTheMethodsOrder) {
    for (const OdeMethod method : odeMethods) {
        if (needsMechanical(method)) continue;
        SCOPED_TRACE(methodName(method));
        const auto error = [&](double h) {
            const Complex z = h * Complex(-0.6, 0.8);
            return std::abs(stabilityFunction(method, z) - std::exp(z));
        };
        // BDF2's root, like each method's factor, is off by h^(p+1); the next power of h bends the slope by about h.
        EXPECT_NEAR(std::log2(error(0.1) / error(0.05)), methodOrder(method) + 1, 0.25);
    }
}

TEST(OdeStability, LimitsAreTheKnownOnes) {
    EXPECT_NEAR(stabilityLimit(OdeMethod::symplecticEuler), 2, 1e-6);
    EXPECT_NEAR(stabilityLimit(OdeMethod::velocityVerlet), 2, 1e-6);
    EXPECT_NEAR(stabilityLimit(OdeMethod::rungeKutta4), 2 * std::sqrt(2), 1e-6);
    EXPECT_NEAR(stabilityLimit(OdeMethod::dormandPrince), 1.0, 0.01);  // "about 1.0": no closed form
    EXPECT_EQ(stabilityLimit(OdeMethod::explicitEuler), 0);
    EXPECT_EQ(stabilityLimit(OdeMethod::explicitMidpoint), 0);
    for (const OdeMethod method :
         {OdeMethod::implicitEuler, OdeMethod::implicitMidpoint, OdeMethod::bdf2, OdeMethod::rodas, OdeMethod::radau}) {
        EXPECT_EQ(stabilityLimit(method), infinite) << methodName(method);
    }
}

// The largest |q| that an undamped spring comes to, which starts at 1.
double largest(OdeMethod method, double wh, int steps) {
    FixedStepper stepper(springCase(1, 0).problem, method, 0, wh, {1, 0});
    double size = 0;
    for (int i = 0; i < steps && stepper.step(); ++i) size = std::max(size, std::abs(stepper.state()[0]));
    return size;
}

TEST(OdeStability, LimitsAreMeasuredWithinOnePercent) {
    for (const OdeMethod method :
         {OdeMethod::symplecticEuler, OdeMethod::velocityVerlet, OdeMethod::rungeKutta4, OdeMethod::dormandPrince}) {
        SCOPED_TRACE(methodName(method));
        const double limit = stabilityLimit(method);
        // 1 % inside a symplectic method's ellipse is 10 long (1/sqrt(1 - (wh/2)^2) = 7.1); the others' circles shrink.
        EXPECT_LT(largest(method, 0.99 * limit, 20000), needsMechanical(method) ? 10 : 1.001);
        // 1 % outside each step grows by 5e-6 (Dormand-Prince) or more: 2.7 = e.
        EXPECT_GT(largest(method, 1.01 * limit, 200000), 2);
    }
    // 200 steps of 0.1: by 1 + 0.005 each, which makes 2.7, and by 1 + 1.25e-5.
    EXPECT_GT(largest(OdeMethod::explicitEuler, 0.1, 200), 2);
    EXPECT_GT(largest(OdeMethod::explicitMidpoint, 0.1, 200000), 10);
}

TEST(OdeStability, ImplicitMethodsNeverGrowInTheLeftHalfPlane) {
    Random random(3);
    for (const OdeMethod method : odeMethods) {
        if (!isImplicit(method)) continue;
        SCOPED_TRACE(methodName(method));
        for (int i = 0; i < 2000; ++i) {
            const double size = random.logarithmic(1e-6, 1e9), angle = random.number(90, 270);
            const Complex z = std::polar(size, radians(angle));
            EXPECT_LE(amplification(method, Complex(std::min(z.real(), 0.0), z.imag())), 1 + 1e-13) << z;
        }
        // L-stable methods forget what is infinitely stiff; the midpoint rule turns it round.
        const double atInfinity = amplification(method, {-1e12, 0});
        if (method == OdeMethod::implicitMidpoint) {
            EXPECT_NEAR(atInfinity, 1, 1e-11);
        } else {
            EXPECT_LT(atInfinity, method == OdeMethod::bdf2 ? 2e-6 : 1e-11);  // BDF2's root falls like 1/sqrt|z|
        }
    }
    for (const double y : {1e-3, 1.0, 16.7, 1e6}) {
        EXPECT_NEAR(amplification(OdeMethod::implicitMidpoint, {0, y}), 1, 1e-15);
    }
}

TEST(OdeStability, DampingMovesTheLimitOfMechanicalMethods) {
    // Symplectic Euler's matrix has the determinant 1 - c and the trace 2 - k - c, so that k <= 4 - 2 c is stable:
    // critically damped, c = 2 sqrt(k), up to sqrt(k) = 2 sqrt(2) - 2 = 0.828.
    EXPECT_LT(amplification(OdeMethod::symplecticEuler, {-0.828, 0}), 1);
    EXPECT_GT(amplification(OdeMethod::symplecticEuler, {-0.829, 0}), 1);
    // Explicit Euler on real z is stable to -2, Runge-Kutta 4 to -2.785.
    EXPECT_NEAR(amplification(OdeMethod::explicitEuler, {-2, 0}), 1, 1e-15);
    EXPECT_LT(amplification(OdeMethod::rungeKutta4, {-2.785, 0}), 1);
    EXPECT_GT(amplification(OdeMethod::rungeKutta4, {-2.786, 0}), 1);
}

TEST(OdeStability, NeverReturnsNaN) {
    EXPECT_EQ(stabilityFunction(OdeMethod::implicitEuler, 1), Complex(infinite, 0));
    EXPECT_EQ(stabilityFunction(OdeMethod::implicitMidpoint, 2), Complex(infinite, 0));
    EXPECT_EQ(stabilityFunction(OdeMethod::rodas, 4), Complex(infinite, 0));
    // Radau's denominator is 0 at the real eigenvalue of the inverse of its matrix.
    EXPECT_GT(std::abs(stabilityFunction(OdeMethod::radau, radauCoefficients().real)), 1e13);
    for (const OdeMethod method : odeMethods) {
        for (const double size : {1e-300, 1e60, 1e150, 1.7e308}) {
            for (const double angle : {0.0, 90.0, 135.0, 180.0}) {
                const double factor = amplification(method, std::polar(size, radians(angle)));
                EXPECT_FALSE(std::isnan(factor)) << methodName(method) << " " << size << " " << angle;
                if (size < 1) continue;
                EXPECT_TRUE(isImplicit(method) ? factor <= 1 + 1e-13 : factor > 1e50) << methodName(method);
            }
        }
    }
    EXPECT_EQ(refusal([] {
                  amplification(OdeMethod::rodas, {notANumber, 0});
              }),
              "amplification: z must be finite, (nan, 0)");
    EXPECT_EQ(refusal([] {
                  stabilityFunction(OdeMethod::rungeKutta4, {0, infinite});
              }),
              "stabilityFunction: z must be finite, (0, inf)");
    EXPECT_EQ(refusal([] { stabilityFunction(OdeMethod::velocityVerlet, 0); }),
              "stabilityFunction: must be asked for a method with one factor; amplification knows the others, "
              "velocity Verlet");
}

// A chain of n masses between two walls has w_j = 2 sqrt(k/m) sin(j pi/(2 (n + 1))), and damping c = ratio * k makes of
// each -ratio w^2/2 +- sqrt((ratio w^2/2)^2 - w^2).
TEST(OdeStability, EigenvaluesOfAChainAreItsFormula) {
    constexpr int n = 7;
    constexpr double k = 1e6, m = 0.1;
    for (const double ratio : {0.0, 1e-5, 1e-2}) {
        SpringSystem chain;
        std::vector<vec3> places;
        for (int i = 0; i <= n + 1; ++i) {
            chain.points.push_back({.mass = m, .isFixed = i == 0 || i == n + 1});
            places.emplace_back(i, 0, 0);
            if (i == 0) continue;
            const auto at = static_cast<std::size_t>(i);
            chain.springs.push_back({.a = at - 1, .b = at, .stiffness = k, .restLength = 1, .damping = ratio * k});
        }
        const auto state = springState(places, std::vector<vec3>(n + 2, vec3(0)));
        const std::vector<Complex> found = eigenvalues(springProblem(chain), 0, state);
        ASSERT_EQ(found.size(), state.size());
        std::vector<Complex> expected(state.size());
        for (int j = 0; j < n; ++j) {
            const double w = 2 * std::sqrt(k / m) * std::sin((j + 1) * pi / (2 * (n + 1)));
            const Complex half = -ratio * w * w / 2, root = std::sqrt(half * half - w * w);
            expected[2 * static_cast<std::size_t>(j)] = half + root;
            expected[2 * static_cast<std::size_t>(j) + 1] = half - root;
        }
        const double largest = std::abs(found[0]);
        for (const Complex& one : expected) {
            double nearest = infinite;
            for (const Complex& other : found) nearest = std::min(nearest, std::abs(one - other));
            // 14 unknowns, roundings of the largest
            EXPECT_LT(nearest, 1e-14 * largest) << one << " " << ratio;
        }
        // Across the chain nothing pulls, and fixed points stay: zeros, exactly
        EXPECT_EQ(std::ranges::count(found, Complex(0)), static_cast<std::ptrdiff_t>(state.size()) - 2 * n);
        EXPECT_TRUE(std::ranges::is_sorted(found, {}, [](const Complex& z) { return -std::norm(z); }));
    }
}

// Either way to say a Jacobian, and differences.
TEST(OdeStability, EigenvaluesOfAnyJacobian) {
    const Complex z(-3, 40);
    OdeProblem problem = complexProblem(z);
    for (const bool isGiven : {true, false}) {
        if (!isGiven) problem.jacobian = {};
        const auto found = eigenvalues(problem, 0, std::vector<double>{1, 2});
        ASSERT_EQ(found.size(), 2U);
        // Differences have half of the digits
        const double off = std::min(std::abs(found[0] - z), std::abs(found[1] - z));
        EXPECT_LT(off, isGiven ? 1e-13 : 1e-5);
        EXPECT_EQ(found[0], std::conj(found[1]));
    }
    problem.jacobian = [](double, std::span<const double>, std::span<double> j) { j[0] = infinite; };
    EXPECT_THROW(eigenvalues(problem, 0, std::vector<double>{1, 2}), Error);
    EXPECT_THROW(eigenvalues(problem, 0, std::vector<double>{1}), Error);
}

TEST(OdeStability, AmplificationOfAPair) {
    Random random(5);
    for (const OdeMethod method : odeMethods) {
        for (int i = 0; i < 50; ++i) {
            const Complex z(random.number(-3, 0), random.number(0, 3));
            EXPECT_DOUBLE_EQ(amplification(method, z, std::conj(z)), amplification(method, z)) << methodName(method);
            // A step of an overdamped oscillator, in the long run
            const double a = random.number(-2.2, -0.01), b = random.number(-2.2, -0.01);
            if (!needsMechanical(method)) {
                EXPECT_EQ(amplification(method, a, b), std::max(amplification(method, a), amplification(method, b)));
                continue;
            }
            const OdeProblem problem{.dimension = 2,
                                     .slope =
                                         [=](double, std::span<const double> y, std::span<double> dydt) {
                                             dydt[0] = y[1];
                                             dydt[1] = -a * b * y[0] + (a + b) * y[1];
                                         },
                                     .isMechanical = true};
            // Its matrix, from the steps of both unit vectors; of that, the larger root of its polynomial
            FixedStepper first(problem, method, 0, 1, {1, 0}), second(problem, method, 0, 1, {0, 1});
            ASSERT_TRUE(first.step() && second.step());
            const auto p = first.state(), q = second.state();
            const Complex half = (p[0] + q[1]) / 2, root = std::sqrt(half * half - (p[0] * q[1] - q[0] * p[1]));
            const double larger = std::max(std::abs(half + root), std::abs(half - root));
            // Of a double root, the root of a rounding
            EXPECT_NEAR(amplification(method, a, b), larger, 1e-7) << methodName(method) << " " << a << " " << b;
        }
    }
    EXPECT_THROW(amplification(OdeMethod::rodas, Complex(0, 1), Complex(0, 1)), Error);
    EXPECT_THROW(amplification(OdeMethod::rodas, infinite, 0), Error);
}

}  // namespace
