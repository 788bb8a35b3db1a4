#include "work_precision/solver.h"

#include "mv/motion/ode_adaptive.h"
#include "mv/motion/ode_fixed.h"

namespace mv::work_precision {
namespace {

// How many numbers of y an implicit method computes by equal steps in a second, roughly. A run that takes longer is left out.
constexpr double mostNumbers = 8e6;

Outcome byTolerance(const Problem& problem, OdeMethod method, double tolerance) {
    AdaptiveOptions options{.relative = tolerance, .absolute = tolerance * problem.floor, .mostSteps = mostSteps};
    options.stops = problem.stops;
    const OdeCase& ode = problem.ode;
    OdeResult result = integrateAdaptive(ode.problem, method, ode.start, ode.end, ode.initial, options);
    return {std::move(result.failure), std::move(result.atStops), result.counts};
}

void add(OdeCounts& sum, const OdeCounts& counts) {
    sum.evaluations += counts.evaluations;
    sum.jacobians += counts.jacobians;
    sum.factorizations += counts.factorizations;
    sum.newtonIterations += counts.newtonIterations;
    sum.accepted += counts.accepted;
    sum.rejected += counts.rejected;
}

Outcome byEqualSteps(const Problem& problem, OdeMethod method, double steps) {
    Outcome outcome;
    std::vector<double> y = problem.ode.initial;
    double before = problem.ode.start;
    for (const double stop : problem.stops) {
        OdeResult result =
            integrateFixed(problem.ode.problem, method, before, stop, static_cast<std::int64_t>(steps), std::move(y));
        add(outcome.counts, result.counts);
        if (!result.reachedEnd()) {
            outcome.failure = std::move(result.failure);
            return outcome;
        }
        y = result.y;
        outcome.states.push_back(std::move(result.y));
        before = stop;
    }
    return outcome;
}

}  // namespace

std::vector<double> tolerances() { return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}; }
std::vector<double> stepNumbers() { return {10, 100, 1000, 10000}; }

std::vector<Solver> ourSolvers() {
    std::vector<Solver> solvers;
    for (const OdeMethod method : odeMethods) {
        Solver solver{.name = std::string(methodName(method)),
                      .hasTolerance = isAdaptive(method),
                      .parameters = isAdaptive(method) ? tolerances() : stepNumbers(),
                      .refusal = {},
                      .prepare = {}};
        solver.refusal = [=](const Problem& problem, double parameter) -> std::string {
            if (needsMechanical(method) && !problem.ode.problem.isMechanical) {
                return "it needs positions and velocities";
            }
            const double numbers = parameter * static_cast<double>(problem.stops.size() * problem.ode.initial.size());
            if (!isAdaptive(method) && isImplicit(method) && numbers > mostNumbers)
                return "left out: more than a second";
            return "";
        };
        solver.prepare = [=](const Problem& problem, double parameter) {
            return [&problem, method, parameter] {
                return isAdaptive(method) ? byTolerance(problem, method, parameter)
                                          : byEqualSteps(problem, method, parameter);
            };
        };
        solvers.push_back(std::move(solver));
    }
    return solvers;
}

}  // namespace mv::work_precision
