#include "mv/motion/ode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/support.h"
#include "mv/motion/ode_problems.h"

using namespace mv;
using namespace mv::test;

namespace {

using Values = std::vector<double>;

Values analyticJacobian(const OdeProblem& problem, const Values& y) {
    const std::size_t n = problem.dimension;
    Values jacobian(n * n);
    if (problem.jacobian) {
        problem.jacobian(0, y, jacobian);
    } else {
        std::vector<MatrixEntry> entries;
        problem.sparseJacobian(0, y, entries);
        for (const auto& [row, column, value] : entries) {
            jacobian[static_cast<std::size_t>(row) * n + static_cast<std::size_t>(column)] += value;
        }
    }
    return jacobian;
}

TEST(DifferencedJacobian, IsTheAnalyticOne) {
    for (const OdeCase& ode : odeCases()) {
        if (!ode.problem.jacobian && !ode.problem.sparseJacobian) continue;
        SCOPED_TRACE(ode.name);
        const std::size_t n = ode.problem.dimension;
        OdeProblem problem = ode.problem;
        for (const double size : ode.reference) problem.scale.push_back(std::abs(size));
        for (const Values& y : {ode.initial, ode.reference}) {
            if (y.empty()) continue;
            Values slope(n);
            ode.problem.slope(0, y, slope);
            std::int64_t evaluations = 0;
            const Values differenced = differencedJacobian(problem, 0, y, slope, 0, evaluations);
            EXPECT_EQ(evaluations, static_cast<std::int64_t>(n));
            const Values analytic = analyticJacobian(ode.problem, y);
            for (std::size_t i = 0; i < n; ++i) {
                double row = 0;
                for (std::size_t j = 0; j < n; ++j) row = std::max(row, std::abs(analytic[i * n + j]));
                for (std::size_t j = 0; j < n; ++j) {
                    // Half of the digits, 1.5e-8, of the terms that a row sums, of which some are 1e3 times the rest.
                    EXPECT_NEAR(differenced[i * n + j], analytic[i * n + j], 1e-4 * row + 1e-12) << i << ", " << j;
                }
            }
        }
    }
}

TEST(DifferencedJacobian, FollowsTheComponentsScale) {
    // The square root of y at a tiny y: a step fit for 1 would be far outside of where the slope is.
    const OdeProblem root{.dimension = 2, .slope = [](double, std::span<const double> y, std::span<double> dydt) {
                              dydt[0] = std::sqrt(y[0]);
                              dydt[1] = y[1];
                          }};
    OdeProblem scaled = root;
    scaled.scale = {1e-20, 1};
    std::int64_t evaluations = 0;
    const Values y{1e-18, 1}, slope{1e-9, 1};
    // d sqrt/dy = 5e8; a forward difference of 1.5e-8 of y is off by 4e-9.
    EXPECT_NEAR(differencedJacobian(scaled, 0, y, slope, 0, evaluations)[0] / 5e8, 1, 1e-7);
    // Without scales the step is that of a thousandth of the largest component: not fit for this one, as the header
    // says.
    EXPECT_LT(differencedJacobian(root, 0, y, slope, 0, evaluations)[0], 1e8);
    // A component that is 0 and does not move is moved all the same, and away from its sign in no case.
    const Values zero = differencedJacobian(root, 0, Values{0, 0}, Values{0, 0}, 0, evaluations);
    EXPECT_TRUE(allFinite(zero));
    EXPECT_EQ(zero[3], 1);
}

TEST(OdeProblem, IsRefusedInWords) {
    const OdeProblem good = springCase(1, 0).problem;
    const auto why = [](const OdeProblem& problem, double t, const Values& y) {
        return refusal([&] { requireProblem("test", problem, t, y); });
    };
    const auto changed = [&](auto change) {
        OdeProblem problem = good;
        change(problem);
        return why(problem, 0, Values(problem.dimension, 1.0));
    };
    EXPECT_EQ(why(good, 0, {1, 0}), "nothing was refused");
    EXPECT_EQ(why(good, 0, {1}), "test: y must have the problem's dimension, 2, 1");
    EXPECT_EQ(why(good, notANumber, {1, 0}), "test: t must be finite, nan");
    EXPECT_EQ(why(good, 0, {1, infinite}), "test: each component of y must be finite, inf");
    EXPECT_EQ(changed([](OdeProblem& p) { p.dimension = 0; }),
              "test: the problem must have a dimension of 1 or more, 0");
    EXPECT_EQ(changed([](OdeProblem& p) { p.slope = {}; }), "test: the problem must have a slope");
    EXPECT_EQ(changed([](OdeProblem& p) { p.sparseJacobian = [](auto, auto, auto&) {}; }),
              "test: the problem must have one Jacobian at most, a dense and a sparse one");
    EXPECT_EQ(changed([](OdeProblem& p) { p.dimension = 3; }),
              "test: a mechanical problem must have as many velocities as positions, 3 numbers");
    EXPECT_EQ(changed([](OdeProblem& p) { p.scale = {1}; }),
              "test: there must be a scale for each component, or none, 1");
    EXPECT_EQ(changed([](OdeProblem& p) {
                  p.scale = {1, 0};
              }),
              "test: each scale must be greater than 0 and finite, 0");
}

TEST(OdeProblem, CasesAreRefusedInWords) {
    EXPECT_EQ(refusal([] { springCase(0, 0); }), "springCase: w must be greater than 0 and finite, 0");
    EXPECT_EQ(refusal([] { springCase(1, 1); }), "springCase: the ratio must be 0 to below 1, 1");
    EXPECT_EQ(refusal([] { vanDerPolCase(notANumber); }), "vanDerPolCase: eps must be greater than 0 and finite, nan");
}

}  // namespace
