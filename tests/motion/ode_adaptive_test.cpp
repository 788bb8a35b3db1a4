#include "mv/motion/ode_adaptive.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "math/support.h"
#include "mv/motion/ode_problems.h"
#include "support/reaction_e5.h"

using namespace mv;
using namespace mv::test;

namespace {

using Values = std::vector<double>;

constexpr std::array adaptiveMethods{OdeMethod::dormandPrince, OdeMethod::rodas, OdeMethod::radau};

// The largest error in units of the tolerance; infinity where anything is NaN.
double inTolerances(const Values& y, const Values& reference, const AdaptiveOptions& options) {
    double worst = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double error =
            std::abs(y[i] - reference[i]) / (options.absolute + options.relative * std::abs(reference[i]));
        worst = std::isnan(error) ? infinite : std::max(worst, error);
    }
    return worst;
}

// The chain's: by the other method, 1000 times as exact. The springs' oscillations of 1e-6 are damped, and it is not
// stiff for 4000 steps of an explicit method.
Values referenceOf(const OdeCase& ode) {
    if (!ode.reference.empty()) return ode.reference;
    const OdeResult exact = integrateAdaptive(ode.problem, OdeMethod::dormandPrince, ode.start, ode.end, ode.initial,
                                              {.relative = 1e-10, .absolute = 1e-13});
    EXPECT_EQ(exact.failure, "");
    return exact.y;
}

TEST(OdeAdaptive, EachProblemIsSolvedOrRefused) {
    for (const OdeCase& ode : odeCases()) {
        const Values reference = referenceOf(ode);
        for (const OdeMethod method : adaptiveMethods) {
            SCOPED_TRACE(ode.name + " by " + std::string(methodName(method)));
            const AdaptiveOptions options{.relative = 1e-6, .absolute = ode.absolute};
            const OdeResult result = integrateAdaptive(ode.problem, method, ode.start, ode.end, ode.initial, options);
            EXPECT_TRUE(allFinite(result.y));
            if (!result.reachedEnd()) {
                // Which only an explicit method on a stiff problem may.
                EXPECT_EQ(method, OdeMethod::dormandPrince);
                EXPECT_NE(result.failure.find("because 100000 steps are not enough"), std::string::npos)
                    << result.failure;
                EXPECT_LT(result.t, ode.end);
                continue;
            }
            EXPECT_EQ(result.t, ode.end);
            // Stars that pass near each other multiply an error by 1e3.
            const double allowed = ode.name == "Pleiades" ? 1000 : 100;
            EXPECT_LT(inTolerances(result.y, reference, options), allowed);
        }
    }
}

TEST(OdeAdaptive, ErrorsFollowTheTolerance) {
    for (const OdeMethod method : adaptiveMethods) {
        SCOPED_TRACE(methodName(method));
        const OdeCase ode = springCase(1, 0.1);
        for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
            const AdaptiveOptions options{.relative = tolerance, .absolute = tolerance};
            const OdeResult result = integrateAdaptive(ode.problem, method, ode.start, ode.end, ode.initial, options);
            EXPECT_EQ(result.failure, "");
            EXPECT_LT(inTolerances(result.y, ode.reference, options), 10) << tolerance;
        }
    }
}

// A sum of components that each slope keeps, each state keeps: a Rosenbrock step keeps linear invariants.
TEST(OdeAdaptive, RodasKeepsTheMassOfRobertsonsReaction) {
    const OdeCase ode = robertsonCase();
    int steps = 0;
    AdaptiveOptions options{.relative = 1e-6, .absolute = ode.absolute};
    options.observe = [&](const AcceptedStep& step) {
        const auto y = step.state();
        ++steps;
        // 6 roundings of each of 600 steps, and of the elimination, whose factors are up to 1e4.
        EXPECT_NEAR(y[0] + y[1] + y[2], 1, 1e-11);
        EXPECT_GE(y[1], 0);
    };
    const OdeResult result = integrateAdaptive(ode.problem, OdeMethod::rodas, 0, ode.end, ode.initial, options);
    EXPECT_EQ(result.failure, "");
    EXPECT_EQ(steps, result.counts.accepted);
}

TEST(OdeAdaptive, ADifferencedJacobianServes) {
    for (OdeCase ode : {robertsonCase(), vanDerPolCase(1e-6), hiresCase(), oregonatorCase()}) {
        SCOPED_TRACE(ode.name);
        ode.problem.jacobian = {};
        const AdaptiveOptions options{.relative = 1e-6, .absolute = ode.absolute};
        const OdeResult byRadau =
            integrateAdaptive(ode.problem, OdeMethod::radau, ode.start, ode.end, ode.initial, options);
        EXPECT_EQ(byRadau.failure, "");
        EXPECT_LT(inTolerances(byRadau.y, ode.reference, options), 100);
        const OdeResult result =
            integrateAdaptive(ode.problem, OdeMethod::rodas, ode.start, ode.end, ode.initial, options);
        EXPECT_EQ(result.failure, "");
        EXPECT_LT(inTolerances(result.y, ode.reference, options), 100);
        const auto n = static_cast<std::int64_t>(ode.problem.dimension);
        const OdeCounts& c = result.counts;
        // Per Jacobian its columns and f; per step tried five stages more; two for the first step's length.
        EXPECT_EQ(c.evaluations, c.jacobians * (n + 1) + 5 * (c.accepted + c.rejected) + 2);
    }
}

TEST(OdeAdaptive, CountsAreRight) {
    std::int64_t evaluations = 0;
    OdeCase ode = oregonatorCase();
    ode.problem.slope = [&, slope = ode.problem.slope](double t, std::span<const double> y, std::span<double> dydt) {
        ++evaluations;
        slope(t, y, dydt);
    };
    std::int64_t steps = 0;
    AdaptiveOptions options{.relative = 1e-4, .absolute = 1e-4};
    options.observe = [&](const AcceptedStep&) { ++steps; };
    const OdeCounts rodas = integrateAdaptive(ode.problem, OdeMethod::rodas, 0, ode.end, ode.initial, options).counts;
    EXPECT_EQ(rodas.evaluations, evaluations);
    EXPECT_EQ(rodas.accepted, steps);
    EXPECT_GT(rodas.rejected, 0);
    EXPECT_EQ(rodas.jacobians, rodas.accepted);  // a rejected step starts where the next one does
    EXPECT_EQ(rodas.factorizations, rodas.accepted + rodas.rejected);
    EXPECT_EQ(rodas.newtonIterations, 0);

    evaluations = steps = 0;
    const OdeCounts radau = integrateAdaptive(ode.problem, OdeMethod::radau, 0, ode.end, ode.initial, options).counts;
    EXPECT_EQ(radau.evaluations, evaluations);
    EXPECT_EQ(radau.accepted, steps);
    EXPECT_GT(radau.rejected, 0);
    EXPECT_LT(radau.jacobians, radau.accepted);  // some are kept
    EXPECT_EQ(radau.factorizations % 2, 0);      // a real and a complex one
    EXPECT_LT(radau.factorizations, 2 * (radau.accepted + radau.rejected));
    // Three an iteration; one at the start of a step; two for the first step's length; and where an error of the first
    // step or after a rejection is too large, one more.
    const std::int64_t fewest = 3 * radau.newtonIterations + radau.accepted + 2;
    EXPECT_GE(radau.evaluations, fewest);
    EXPECT_LE(radau.evaluations, fewest + radau.rejected);

    evaluations = steps = 0;
    const OdeCounts explicitly =
        integrateAdaptive(ode.problem, OdeMethod::dormandPrince, 0, 5, ode.initial, options).counts;
    EXPECT_EQ(explicitly.evaluations, evaluations);
    EXPECT_EQ(explicitly.accepted, steps);
    // Six a step, since the last stage is the next one's first; one at the start, two for the first step's length.
    EXPECT_EQ(explicitly.evaluations, 6 * (explicitly.accepted + explicitly.rejected) + 3);
    EXPECT_EQ(explicitly.factorizations, 0);
}

TEST(OdeAdaptive, DenseOutputHasItsOrder) {
    // q'' = -q and a clock, so that f reads t: y = cos t.
    const OdeProblem problem{.dimension = 2, .slope = [](double t, std::span<const double> y, std::span<double> dydt) {
                                 dydt[0] = -std::sin(t) + 0.5 * (y[1] - std::sin(t));
                                 dydt[1] = std::cos(t) - 0.5 * (y[0] - std::cos(t));
                             }};
    for (const OdeMethod method : adaptiveMethods) {
        SCOPED_TRACE(methodName(method));
        const auto error = [&](double h) {
            double worst = 0;
            AdaptiveOptions options{.relative = 0.1, .absolute = 1, .firstStep = h, .mostSteps = 1};
            options.observe = [&](const AcceptedStep& step) {
                for (int i = 0; i <= 10; ++i) {
                    const double t = std::min(step.from() + i * (step.to() - step.from()) / 10, step.to());
                    Values y(2);
                    step.at(t, y);
                    worst = std::max({worst, std::abs(y[0] - std::cos(t)), std::abs(y[1] - std::sin(t))});
                    // At the ends a sum of numbers of size 1.
                    const double expected = i == 0 ? std::cos(step.from()) : step.state()[0];
                    EXPECT_TRUE((i > 0 && i < 10) || std::abs(y[0] - expected) < 1e-15);
                }
                Values two(2), one(1);
                EXPECT_EQ(refusal([&] { step.at(step.to() + 1, two); }).substr(0, 27), "AcceptedStep: t must be fro");
                EXPECT_EQ(refusal([&] { step.at(step.to(), one); }),
                          "AcceptedStep: the result must have room for 2 numbers, 1");
            };
            integrateAdaptive(problem, method, 1, 100, {std::cos(1.0), std::sin(1.0)}, options);
            return worst;
        };
        // One step of an interpolation of order q is off by h^(q+1): 4 and 3.
        EXPECT_NEAR(std::log2(error(0.2) / error(0.1)), method == OdeMethod::dormandPrince ? 5 : 4, 0.4);
    }
}

TEST(OdeAdaptive, GivesUpInWords) {
    // y = 1/(1 - t) has no value at 1.
    const OdeProblem pole{.dimension = 1, .slope = [](double, std::span<const double> y, std::span<double> dydt) {
                              dydt[0] = y[0] * y[0];
                          }};
    // There is no f at t > 1.
    const OdeProblem end{.dimension = 1, .slope = [](double t, std::span<const double>, std::span<double> dydt) {
                             dydt[0] = std::sqrt(1 - t);
                         }};
    for (const OdeMethod method : adaptiveMethods) {
        SCOPED_TRACE(methodName(method));
        const OdeResult atPole = integrateAdaptive(pole, method, 0, 2, {1});
        EXPECT_NE(atPole.failure.find("shorter than 16 roundings of t"), std::string::npos) << atPole.failure;
        // As near to the pole as the tolerance lets it be known.
        EXPECT_NEAR(atPole.t, 1, 1e-4);
        EXPECT_TRUE(allFinite(atPole.y));
        EXPECT_GT(atPole.y[0], 1e3);

        const OdeResult atEnd = integrateAdaptive(end, method, 0, 2, {0});
        EXPECT_NE(atEnd.failure.find("is not finite"), std::string::npos) << atEnd.failure;
        EXPECT_LE(atEnd.t, 1);
        EXPECT_NEAR(atEnd.t, 1, 1e-3);
        EXPECT_TRUE(allFinite(atEnd.y));

        const OdeResult few = integrateAdaptive(pole, method, 0, 0.9, {1}, {.mostSteps = 2});
        EXPECT_NE(few.failure.find("because 2 steps are not enough"), std::string::npos) << few.failure;

        // A start whose rounding is longer than the interval's sixteenth.
        const OdeResult late = integrateAdaptive(pole, method, 1e16, 1e16 + 4, {1});
        EXPECT_NE(late.failure.find("shorter than 16 roundings of t"), std::string::npos) << late.failure;
        EXPECT_EQ(late.y, Values{1});
    }
}

// 1/(h gamma) = 4 is the eigenvalue: there is nothing to divide by, and another step has to be tried.
TEST(OdeAdaptive, ASingularMatrixShortensTheStep) {
    const OdeProblem growth{
        .dimension = 1,
        .slope = [](double, std::span<const double> y, std::span<double> dydt) { dydt[0] = 4 * y[0]; },
        .jacobian = [](double, std::span<const double>, std::span<double> j) { j[0] = 4; }};
    const OdeResult result = integrateAdaptive(growth, OdeMethod::rodas, 0, 2, {1}, {.firstStep = 1});
    EXPECT_EQ(result.failure, "");
    EXPECT_GT(result.counts.rejected, 0);
    EXPECT_NEAR(result.y[0] / std::exp(8.0), 1, 100e-6);  // 100 tolerances
}

// One evaluation of J and two factorizations are enough for what is linear, while the step is.
TEST(OdeAdaptive, RadauKeepsTheMatricesOfALinearProblem) {
    const OdeCase ode = springCase(1, 0);
    const OdeResult result =
        integrateAdaptive(ode.problem, OdeMethod::radau, 0, 1000, ode.initial, {.relative = 1e-6, .absolute = 1e-6});
    EXPECT_EQ(result.failure, "");
    EXPECT_EQ(result.counts.jacobians, 1);
    EXPECT_LT(result.counts.factorizations, result.counts.accepted / 10);
}

TEST(OdeAdaptive, StepsEndAtStops) {
    const OdeCase ode = robertsonCase();
    for (const OdeMethod method : {OdeMethod::rodas, OdeMethod::radau}) {
        SCOPED_TRACE(methodName(method));
        std::vector<double> ends;
        AdaptiveOptions options{.relative = 1e-6, .absolute = ode.absolute, .stops = {1e-3, 0.4, 1e11}};
        std::vector<Values> seen;
        options.observe = [&](const AcceptedStep& step) {
            for (const double stop : options.stops) {
                if (step.to() == stop) seen.emplace_back(step.state().begin(), step.state().end());
            }
        };
        const OdeResult result = integrateAdaptive(ode.problem, method, 0, ode.end, ode.initial, options);
        EXPECT_EQ(result.failure, "");
        EXPECT_EQ(result.atStops, seen);
        ASSERT_EQ(result.atStops.size(), 3U);
        EXPECT_EQ(result.atStops.back(), result.y);
        // A stop costs a step or two, not the way to long ones anew, which takes dozens.
        const std::int64_t stopped = result.counts.accepted;
        options.stops.clear();
        EXPECT_LE(stopped,
                  integrateAdaptive(ode.problem, method, 0, ode.end, ode.initial, options).counts.accepted + 10);
        // A run that gives up before has fewer.
        options.stops = {1e-3, 1e10};
        options.mostSteps = 100;
        EXPECT_EQ(integrateAdaptive(ode.problem, method, 0, ode.end, ode.initial, options).atStops.size(), 1U);
    }
    const auto why = [&](std::vector<double> stops) {
        return refusal(
            [&] { integrateAdaptive(ode.problem, OdeMethod::rodas, 0, 1, ode.initial, {.stops = std::move(stops)}); });
    };
    EXPECT_EQ(why({0}), "RODAS 4(3): stops must ascend from after the start to the end, 0");
    EXPECT_EQ(why({0.5, 0.5}), "RODAS 4(3): stops must ascend from after the start to the end, 0.5");
    EXPECT_EQ(why({0.5, 1.5}), "RODAS 4(3): stops must ascend from after the start to the end, 1.5");
    EXPECT_EQ(why({notANumber}), "RODAS 4(3): stops must ascend from after the start to the end, nan");
}

TEST(OdeAdaptive, AResultIsConfirmedOrDoubted) {
    const auto confirmed = [](const OdeCase& ode, OdeMethod method, const AdaptiveOptions& options) {
        const OdeResult result = integrateAdaptive(ode.problem, method, ode.start, ode.end, ode.initial, options);
        EXPECT_EQ(result.failure, "");
        return confirmAdaptive(ode.problem, method, ode.start, ode.end, ode.initial, options, result);
    };
    for (const OdeMethod method : adaptiveMethods) {
        const OdeCase ode = springCase(1, 0.1);
        int observed = 0;
        AdaptiveOptions options{.relative = 1e-6, .absolute = 1e-6, .stops = {1, 2, 10}};
        options.observe = [&](const AcceptedStep&) { ++observed; };
        const OdeResult result = integrateAdaptive(ode.problem, method, 0, ode.end, ode.initial, options);
        const int steps = observed;
        const Confirmation found = confirmAdaptive(ode.problem, method, 0, ode.end, ode.initial, options, result);
        EXPECT_EQ(found.doubt, "");
        EXPECT_EQ(observed, steps) << "the second run is nobody's to observe";
        EXPECT_GT(found.counts.evaluations, result.counts.evaluations);
        // The second run errs by about a tenth: what differs is the first one's error.
        const double error = inTolerances(result.y, ode.reference, options) * options.relative;
        EXPECT_GT(found.difference, error / 2);
        EXPECT_LT(found.difference, 100 * options.relative);
        // A change at a stop alone is seen there.
        OdeResult wrong = result;
        wrong.atStops[1][0] += 0.7;
        EXPECT_NE(confirmAdaptive(ode.problem, method, 0, ode.end, ode.initial, options, wrong)
                      .doubt.find("at t = 2, a component differs by "),
                  std::string::npos);
    }
    const OdeCase stars = pleiadesCase();
    EXPECT_NE(confirmed(stars, OdeMethod::dormandPrince, {.relative = 1e-2, .absolute = 1e-2}).doubt, "");
    EXPECT_EQ(confirmed(stars, OdeMethod::dormandPrince, {.relative = 1e-6, .absolute = 1e-6}).doubt, "");
    // The second run may fail where the first did not: here for want of steps, of which the first took all.
    AdaptiveOptions few{.relative = 1e-6, .absolute = 1e-6};
    const OdeCounts taken =
        integrateAdaptive(stars.problem, OdeMethod::dormandPrince, stars.start, stars.end, stars.initial, few).counts;
    few.mostSteps = taken.accepted + taken.rejected;
    const Confirmation tooFew = confirmed(stars, OdeMethod::dormandPrince, few);
    EXPECT_EQ(tooFew.doubt.rfind("by a tenth of the tolerance it gave up at t = ", 0), 0U) << tooFew.doubt;

    const OdeCase ode = springCase(1, 0);
    const auto why = [&](const AdaptiveOptions& options, const OdeResult& result, double allowed) {
        return refusal(
            [&] { confirmAdaptive(ode.problem, OdeMethod::rodas, 0, 1, ode.initial, options, result, allowed); });
    };
    const OdeResult right = integrateAdaptive(ode.problem, OdeMethod::rodas, 0, 1, ode.initial);
    EXPECT_EQ(why({}, right, 0), "confirmAdaptive: the allowed difference must be greater than 0 and finite, 0");
    EXPECT_EQ(why({}, {.failure = "gave up"}, 1), "confirmAdaptive: the result must have reached the end, gave up");
    EXPECT_EQ(why({.stops = {1}}, right, 1),
              "confirmAdaptive: the result must be of this problem and these stops, 2 numbers at 0 stops");
    EXPECT_EQ(why({.relative = 5e-13}, right, 1), "RODAS 4(3): the relative tolerance must be 1e-13 to 0.1, 5e-14");
}

// E5's y2 - y3 - y4 is 0, and drifts; y2 and y3 fall to 8.9e-23. That RODAS is wrong there is said in mv/motion/ode_adaptive.h.
TEST(OdeAdaptive, RadauKeepsWhatRodasLosesInE5) {
    const OdeCase e5 = e5Case();
    std::array<double, 2> errors{}, drifts{};
    for (const OdeMethod method : {OdeMethod::rodas, OdeMethod::radau}) {
        const std::size_t which = method == OdeMethod::rodas ? 0 : 1;
        const OdeResult result = integrateAdaptive(e5.problem, method, e5.start, e5.end, e5.initial,
                                                   {.relative = 1e-6, .absolute = e5.absolute, .stops = {1e5}});
        ASSERT_EQ(result.failure, "");
        errors.at(which) =
            std::max(std::abs(result.y[1] / e5.reference[1] - 1), std::abs(result.y[2] / e5.reference[2] - 1));
        const std::vector<double>& y = result.atStops.at(0);
        drifts.at(which) = std::abs(y[1] - y[2] - y[3]);
    }
    EXPECT_GT(errors[0], 1);
    EXPECT_LT(errors[1], 0.01) << "the reference's own two, which ought to be equal, are 0.0015 apart";
    EXPECT_LT(drifts[1], 0.01 * drifts[0]);
}

TEST(OdeAdaptive, RestCostsNothing) {
    const OdeProblem still{.dimension = 1,
                           .slope = [](double, std::span<const double>, std::span<double> dydt) { dydt[0] = 0; }};
    for (const OdeMethod method : adaptiveMethods) {
        const OdeResult result = integrateAdaptive(still, method, 0, 1e9, {3});
        EXPECT_EQ(result.y, Values{3});
        EXPECT_LT(result.counts.accepted, 12);  // from 1e-6 of the interval, each step 8 times the one before
    }
}

TEST(OdeAdaptive, TheImpossibleIsRefused) {
    const OdeCase ode = springCase(1, 0);
    const auto why = [&](OdeMethod method, double end, const AdaptiveOptions& options) {
        return refusal([&] { integrateAdaptive(ode.problem, method, 0, end, {1, 0}, options); });
    };
    const OdeMethod rodas = OdeMethod::rodas;
    EXPECT_EQ(why(rodas, 1, {.relative = 9e-14}), "RODAS 4(3): the relative tolerance must be 1e-13 to 0.1, 9e-14");
    EXPECT_EQ(why(rodas, 1, {.relative = notANumber}), "RODAS 4(3): the relative tolerance must be 1e-13 to 0.1, nan");
    EXPECT_EQ(why(rodas, 1, {.absolute = 0}),
              "RODAS 4(3): the absolute tolerance must be greater than 0 and finite, 0");
    EXPECT_EQ(why(rodas, 1, {.firstStep = -1}),
              "RODAS 4(3): the first step, where it is given, must be greater than 0 and finite, -1");
    EXPECT_EQ(why(rodas, 1, {.mostSteps = 0}), "RODAS 4(3): mostSteps must be 1 or more, 0");
    EXPECT_EQ(why(rodas, 0, {}), "RODAS 4(3): end must be after start, 0");
    EXPECT_EQ(why(rodas, infinite, {}), "RODAS 4(3): end must be finite, inf");
    EXPECT_EQ(why(OdeMethod::rungeKutta4, 1, {}),
              "Runge-Kutta 4: must be Dormand-Prince, RODAS or Radau to choose its steps: it has no error estimate");
}

}  // namespace
