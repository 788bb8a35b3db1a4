#include "work_precision/rosenbrock4.h"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <utility>

namespace mv::work_precision {

Rosenbrock4Outcome rosenbrock4(const Rosenbrock4Problem& problem, double relative, double absolute, long mostSteps) {
    namespace odeint = boost::numeric::odeint;
    using Vector = boost::numeric::ublas::vector<double>;
    using Matrix = boost::numeric::ublas::matrix<double>;
    const auto slope = [&](const Vector& y, Vector& result, double t) {
        problem.slope(t, y.data().begin(), result.data().begin());
    };
    const auto jacobian = [&](const Vector& y, Matrix& result, double t, Vector& timeSlope) {
        timeSlope.clear();
        result.clear();
        problem.jacobian(t, y.data().begin(), result.data().begin());
    };
    const auto system = std::make_pair(slope, jacobian);
    auto stepper = odeint::make_controlled(absolute, relative, odeint::rosenbrock4<double>());
    Rosenbrock4Outcome outcome;
    Vector y(problem.dimension);
    std::copy(problem.initial.begin(), problem.initial.end(), y.begin());
    double t = 0, h = 1e-3 * problem.stops.front();
    for (const double stop : problem.stops) {
        while (t < stop) {
            const double wanted = h;
            const bool isLast = h * 1.01 >= stop - t;
            if (isLast) h = stop - t;
            if (outcome.accepted + outcome.rejected == mostSteps) {
                outcome.failure = "gave up: " + std::to_string(mostSteps) + " steps are not enough";
                return outcome;
            }
            if (!(h > 1e-15 * t)) {
                outcome.failure = "gave up: its step is shorter than a rounding, or no number";
                return outcome;
            }
            if (stepper.try_step(system, y, t, h) == odeint::success) {
                ++outcome.accepted;
                if (isLast) {
                    t = stop;
                    h = std::max(h, wanted);
                }
            } else {
                ++outcome.rejected;
            }
        }
        for (const double component : y) {
            if (std::isfinite(component)) continue;
            outcome.failure = "its state is not finite";
            return outcome;
        }
        outcome.states.emplace_back(y.begin(), y.end());
    }
    return outcome;
}

}  // namespace mv::work_precision
