#include "mv/motion/ode.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {

bool allFinite(std::span<const double> numbers) {
    double sum = 0;  // of zeros, or NaN
    for (const double x : numbers) sum += x - x;
    return sum == 0;
}

void requireProblem(std::string_view subject, const OdeProblem& problem, double t, std::span<const double> y) {
    if (problem.dimension == 0) throw Error(subject, "the problem must have a dimension of 1 or more", "0");
    if (!problem.slope) throw Error(subject, "the problem must have a slope");
    if (problem.jacobian && problem.sparseJacobian) {
        throw Error(subject, "the problem must have one Jacobian at most", "a dense and a sparse one");
    }
    if (problem.isMechanical && problem.dimension % 2 != 0) {
        throw Error(subject, "a mechanical problem must have as many velocities as positions",
                    std::to_string(problem.dimension) + " numbers");
    }
    if (!problem.scale.empty() && problem.scale.size() != problem.dimension) {
        throw Error(subject, "there must be a scale for each component, or none", std::to_string(problem.scale.size()));
    }
    for (const double scale : problem.scale) requirePositive(subject, "each scale", scale);
    requireFinite(subject, "t", t);
    if (y.size() != problem.dimension) {
        throw Error(subject, "y must have the problem's dimension, " + std::to_string(problem.dimension),
                    std::to_string(y.size()));
    }
    for (const double component : y) requireFinite(subject, "each component of y", component);
}

std::vector<double> differencedJacobian(const OdeProblem& problem, double t, std::span<const double> y,
                                        std::span<const double> slope, double span, std::int64_t& evaluations) {
    const std::size_t n = problem.dimension;
    std::vector<double> jacobian(n * n), moved(y.begin(), y.end()), movedSlope(n);
    double largest = 0;
    for (const double component : y) largest = std::max(largest, std::abs(component));
    if (largest == 0) largest = 1;

    for (std::size_t j = 0; j < n; ++j) {
        const double own = std::max(std::abs(y[j]), std::abs(span * slope[j]));
        // A component that is 0 but for roundings tells nothing of its size.
        const double floor = (own < 1e-14 * largest ? 1e-3 : 1e-6) * largest;
        const double size = std::max(own, problem.scale.empty() ? floor : problem.scale[j]);
        // Towards larger sizes, so that no component leaves its sign: many problems are defined for one sign only.
        moved[j] = y[j] + std::copysign(std::sqrt(std::numeric_limits<double>::epsilon()) * size, y[j]);
        const double step = moved[j] - y[j];  // what it is after rounding
        problem.slope(t, moved, movedSlope);
        ++evaluations;
        for (std::size_t i = 0; i < n; ++i) jacobian[i * n + j] = (movedSlope[i] - slope[i]) / step;
        moved[j] = y[j];
    }
    return jacobian;
}

}  // namespace mv
