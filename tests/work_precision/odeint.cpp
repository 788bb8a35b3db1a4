#include "work_precision/rosenbrock4.h"
#include "work_precision/solver.h"

namespace mv::work_precision {
namespace {

Outcome run(const Problem& problem, double tolerance) {
    const OdeCase& ode = problem.ode;
    const std::size_t n = ode.initial.size();
    OdeCounts counts;
    std::vector<MatrixEntry> entries;
    Rosenbrock4Problem own{.dimension = n, .slope = {}, .jacobian = {}, .initial = ode.initial, .stops = problem.stops};
    own.slope = [&](double t, const double* y, double* slope) {
        ode.problem.slope(t, {y, n}, {slope, n});
        ++counts.evaluations;
    };
    own.jacobian = [&](double t, const double* y, double* jacobian) {
        ++counts.jacobians;
        ++counts.factorizations;  // one each
        if (ode.problem.jacobian) {
            ode.problem.jacobian(t, {y, n}, {jacobian, n * n});
        } else if (ode.problem.sparseJacobian) {
            entries.clear();
            ode.problem.sparseJacobian(t, {y, n}, entries);
            for (const MatrixEntry& entry : entries) {
                jacobian[static_cast<std::size_t>(entry.row) * n + static_cast<std::size_t>(entry.column)] +=
                    entry.value;
            }
        } else {
            std::vector<double> slope(n);
            own.slope(t, y, slope.data());
            const std::vector<double> differenced =
                differencedJacobian(ode.problem, t, {y, n}, slope, 0, counts.evaluations);
            std::copy(differenced.begin(), differenced.end(), jacobian);
        }
    };
    Rosenbrock4Outcome outcome = rosenbrock4(own, tolerance, tolerance * problem.floor, mostSteps);
    counts.accepted = outcome.accepted;
    counts.rejected = outcome.rejected;
    return {std::move(outcome.failure), std::move(outcome.states), counts};
}

}  // namespace

Solver odeintRosenbrock() {
    return {.name = "Odeint rosenbrock4",
            .hasTolerance = true,
            .parameters = tolerances(),
            .refusal =
                [](const Problem& problem, double tolerance) {
                    // 200 rows, dense: 2 ms for each of many hundred steps.
                    return problem.ode.initial.size() > 100 && tolerance < 1e-7 ? "left out: about a second or more"
                                                                                : "";
                },
            .prepare = [](const Problem& problem,
                          double tolerance) { return [&problem, tolerance] { return run(problem, tolerance); }; }};
}

}  // namespace mv::work_precision
