// docs/work-precision.md: what it says holds of its rows, which are measured again, against references that are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include "mv/image/file.h"
#include "mv/motion/ode_adaptive.h"
#include "mv/motion/ode_fixed.h"
#include "mv/study/claims.h"
#include "mv/study/study.h"
#include "work_precision/page.h"

using namespace mv;
using namespace mv::work_precision;

namespace {

bool isLong() { return std::getenv("MVGL_LONG") != nullptr; }

std::string fileText(const std::string& name) {
    std::ifstream stream(std::string(MVGL_SOURCE_DIR "/docs/") + name, std::ios::binary);
    EXPECT_TRUE(stream) << name;
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

const StudyRun& committed() {
    static const StudyRun run = rowsFrom(fileText("work-precision.csv"));
    return run;
}

TEST(WorkPrecision, ThePageAndTheCurveAreOfTheRows) {
    if (std::getenv("MVGL_UPDATE_DOCS") != nullptr) {
        writeFileAtomically(MVGL_SOURCE_DIR "/docs/work-precision.svg", std::string_view(studySvg(committed())));
        writeFileAtomically(MVGL_SOURCE_DIR "/docs/work-precision.md", std::string_view(page(committed())));
    }
    EXPECT_EQ(fileText("work-precision.svg"), studySvg(committed()))
        << "MVGL_UPDATE_DOCS=1 build/tests/test-work-precision makes both anew";
    EXPECT_EQ(page(committed()), fileText("work-precision.md"));
}

TEST(WorkPrecision, EveryClaimHoldsOfTheRows) {
    const auto check = [](const StudyRun& run, const std::vector<Saying>& says) {
        for (const Saying& saying : says) {
            for (const Predicate& predicate : saying.predicates) {
                const Evaluation found = evaluate(run, predicate);
                EXPECT_TRUE(found.holds) << saying.id << ": " << found.text;
                for (const std::string& failure : found.failures) ADD_FAILURE() << saying.id << ": " << failure;
            }
        }
    };
    check(committed(), sayings());
    check(atEqualErrors(committed()), sayingsAtEqualErrors());
}

// Each is about its own rows: with those of two methods exchanged it is wrong.
TEST(WorkPrecision, ClaimsFailOfOtherRows) {
    StudyRun exchanged = committed();
    const std::map<std::string, std::string> others{{"Radau IIA 5", "CVODE BDF"},
                                                    {"CVODE BDF", "Radau IIA 5"},
                                                    {"RODAS 4(3)", "CVODE Adams"},
                                                    {"CVODE Adams", "RODAS 4(3)"},
                                                    {"Dormand-Prince 5(4)", "Odeint rosenbrock4"},
                                                    {"Odeint rosenbrock4", "Dormand-Prince 5(4)"},
                                                    {"Runge-Kutta 4", "implicit Euler"},
                                                    {"implicit Euler", "Runge-Kutta 4"}};
    for (StudyRow& row : exchanged.rows) {
        if (const auto other = others.find(row.method); other != others.end()) row.method = other->second;
    }
    const auto holds = [](const StudyRun& run, const Saying& saying) {
        bool all = true;
        for (const Predicate& predicate : saying.predicates) all = all && evaluate(run, predicate).holds;
        return all;
    };
    for (const Saying& saying : sayings()) {
        if (!saying.isClaim()) continue;
        EXPECT_FALSE(holds(exchanged, saying)) << saying.id;
    }
    EXPECT_FALSE(holds(atEqualErrors(exchanged), sayingsAtEqualErrors().front()));
}

TEST(WorkPrecision, ReferencesAreThePublishedOnes) {
    int published = 0;
    for (const Problem& problem : problems()) {
        const States reference = committedReference(problem);
        ASSERT_EQ(reference.size(), problem.stops.size());
        if (problem.ode.reference.empty()) continue;
        ++published;
        for (std::size_t i = 0; i < problem.ode.reference.size(); ++i) {
            // The test set's own are good to 12 digits and more.
            EXPECT_NEAR(reference.back()[i] / problem.ode.reference[i], 1, 2e-13) << problem.ode.name << " " << i;
        }
    }
    EXPECT_EQ(published, 7);
}

TEST(WorkPrecision, ReferencesAreMadeAgain) {
    for (const Problem& problem : problems()) {
        const std::string& name = problem.ode.name;
        if (!isLong() && name != "van der Pol" && name.find("spring") == std::string::npos) continue;
        // Equal to a rounding or two of doubles.
        EXPECT_LT(deviationOf(problem, computedReference(problem), committedReference(problem)).largest, 5e-16) << name;
    }
}

const Solver& solverOf(const std::vector<Solver>& solvers, const std::string& name) {
    for (const Solver& solver : solvers) {
        if (solver.name == name) return solver;
    }
    throw std::runtime_error("no solver " + name);
}

// Errors and counts are the same where pow rounds alike, on which the choice of steps depends; elsewhere a step more or
// less shifts all that follow. A hundredth of the counts and a fifth of an error, and what roundings make, 1e-12.
TEST(WorkPrecision, RowsAreMeasuredAgain) {
    std::vector<Solver> solvers = ourSolvers();
    solvers.push_back(odeintRosenbrock());
    int measured = 0;
    const std::vector<Problem> all = problems();
    for (const StudyRow& row : committed().rows) {
        if (row.method.starts_with("CVODE")) continue;
        // A row without a right answer has no time: a slope takes a microsecond or less.
        const bool isSlow = row.ok() ? row.msMedian > 5 : row.counts.front().second > 100'000;
        if (isSlow && !isLong()) continue;
        const Problem* problem = nullptr;
        for (const Problem& candidate : all) {
            if (candidate.ode.name == row.scene) problem = &candidate;
        }
        ASSERT_TRUE(problem) << row.scene;
        SCOPED_TRACE(row.scene + ", " + row.method + " " + row.parameter);
        const Solver& solver = solverOf(solvers, row.method);
        const double parameter = std::strtod(row.parameter.c_str(), nullptr);
        const std::string refused = solver.refusal(*problem, parameter);
        const StudyRow now = refused.empty() ? rowOf(*problem, solver, parameter, solver.prepare(*problem, parameter)())
                                             : rowLeftOut(*problem, solver, parameter, refused);
        EXPECT_EQ(now.ok(), row.ok()) << now.status << row.status;
        ++measured;
        if (!now.ok() || !row.ok()) {
            // The same reason: the words before any number.
            EXPECT_EQ(now.status.substr(0, 8), row.status.substr(0, 8));
            continue;
        }
        EXPECT_NEAR(now.all.max, row.all.max, 0.2 * row.all.max + 1e-12);
        for (std::size_t i = 0; i < 6; ++i) {
            const auto& [name, before] = row.counts[i];
            EXPECT_NEAR(now.counts[i].second, before, 0.01 * before + 2) << name;
        }
    }
    EXPECT_GT(measured, 400);
}

// y never leaves -2.02 to 2.02, but Newton's method left to itself finds roots beyond. In whatever steps: no L-stable method
// of ours ends on another branch, or else it has given up. (The implicit midpoint rule swings about the right one, undamped.)
TEST(WorkPrecision, NobodyIsOnAnotherBranchOfVanDerPol) {
    const std::vector<Problem> all = problems();
    const Problem& problem = all[4];
    ASSERT_EQ(problem.ode.name, "van der Pol");
    const std::vector<Solver> solvers = ourSolvers();
    for (const char* name : {"implicit Euler", "BDF2", "RODAS 4(3)", "Radau IIA 5"}) {
        const Solver& solver = solverOf(solvers, name);
        for (const double parameter : solver.parameters) {
            const Outcome outcome = solver.prepare(problem, parameter)();
            for (const auto& y : outcome.states) EXPECT_LT(std::abs(y[0]), 2.02) << name << " " << parameter;
        }
    }
    for (const double steps : stepNumbers()) {
        const OdeCase& ode = problem.ode;
        const OdeResult result =
            integrateFixed(ode.problem, OdeMethod::radau, 0, 2, static_cast<int>(steps), ode.initial);
        EXPECT_LT(std::abs(result.y[0]), 2.02) << steps;
    }
}

// Error estimates are of steps. Who has an answer confirmed is never wrong by a component's size without a word: of each
// problem, by each method of ours that chooses its steps, at each tolerance.
TEST(WorkPrecision, WhatIsConfirmedIsNotWrong) {
    int confirmed = 0, wrong = 0;
    const std::vector<Problem> all = problems();
    for (const StudyRow& row : committed().rows) {
        if (row.settings.front().name != "tolerance" || row.status.find("gave up") != std::string::npos) continue;
        const double tolerance = std::strtod(row.parameter.c_str(), nullptr);
        const auto method =
            std::ranges::find_if(odeMethods, [&](OdeMethod candidate) { return methodName(candidate) == row.method; });
        if (method == odeMethods.end() || (row.msMedian > 5 && !isLong())) continue;
        SCOPED_TRACE(row.scene + ", " + row.method + " " + row.parameter);
        const auto problem =
            std::ranges::find_if(all, [&](const Problem& candidate) { return candidate.ode.name == row.scene; });
        ASSERT_NE(problem, all.end());
        const OdeCase& ode = problem->ode;
        AdaptiveOptions options{
            .relative = tolerance, .absolute = tolerance * problem->floor, .mostSteps = 10 * mostSteps};
        options.stops = problem->stops;
        const OdeResult result = integrateAdaptive(ode.problem, *method, ode.start, ode.end, ode.initial, options);
        ASSERT_EQ(result.failure, "");
        const Confirmation confirmation =
            confirmAdaptive(ode.problem, *method, ode.start, ode.end, ode.initial, options, result);
        const double error = deviationOf(*problem, result.atStops, committedReference(*problem)).largest;
        ++confirmed;
        wrong += error > 1 ? 1 : 0;
        if (error > 1) {
            EXPECT_NE(confirmation.doubt, "") << error;
        }
        // Nor does it cry wolf: the second run's error is at most a few tenths of the first one's.
        if (error < 0.25) {
            EXPECT_EQ(confirmation.doubt, "") << error;
        }
    }
    EXPECT_GT(confirmed, 150);
    EXPECT_GE(wrong, 2);
}

// A curve that is not the problem's has an error.
TEST(WorkPrecision, AWrongProblemIsSeen) {
    for (Problem problem : problems()) {
        if (problem.ode.name == "Pleiades") continue;
        OdeProblem& ode = problem.ode.problem;
        ode.slope = [slope = ode.slope](double t, std::span<const double> y, std::span<double> dydt) {
            slope(t, y, dydt);
            for (double& component : dydt) component *= 1.001;
        };
        AdaptiveOptions options{.relative = 1e-8, .absolute = 1e-8 * problem.floor};
        options.stops = problem.stops;
        const OdeResult result =
            integrateAdaptive(ode, OdeMethod::radau, 0, problem.ode.end, problem.ode.initial, options);
        ASSERT_EQ(result.failure, "") << problem.ode.name;
        EXPECT_GT(deviationOf(problem, result.atStops, committedReference(problem)).largest, 1e-4) << problem.ode.name;
    }
}

}  // namespace
