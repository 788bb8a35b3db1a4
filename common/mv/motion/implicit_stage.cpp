#include "mv/motion/implicit_stage.h"

#include <algorithm>
#include <cmath>

namespace mv {
namespace {

constexpr int mostIterations = 30;

// The largest |x_i| / w_i.
double weightedSize(std::span<const double> x, std::span<const double> w) {
    double size = 0;
    for (std::size_t i = 0; i < x.size(); ++i) size = std::max(size, std::abs(x[i]) / w[i]);
    return size;
}

}  // namespace

std::string ImplicitStage::makeMatrix(const OdeProblem& problem, double t, double g, std::span<const double> y,
                                      std::span<const double> slope, OdeCounts& counts) {
    if (!matrix_.evaluate(problem, t, y, slope, g, counts)) return "the Jacobian is not finite";
    if (!matrix_.factorize(1 / g, counts)) return "the matrix of Newton's method is singular";
    matrixG_ = g;
    return "";
}

std::string ImplicitStage::attempt(const OdeProblem& problem, double t, double g, std::span<const double> constant,
                                   std::span<double> y, OdeCounts& counts, bool& isOld) {
    const std::size_t n = y.size();
    std::vector<double> slope(n), correction(n), sizes(n), rows(n);
    // The measure of an error: a component's size, or its scale, or a thousandth of the largest component.
    const auto measure = [&] {
        double largest = 0;
        for (const double component : y) largest = std::max(largest, std::abs(component));
        for (std::size_t i = 0; i < n; ++i) {
            const double floor = problem.scale.empty() ? 1e-3 * largest : problem.scale[i];
            const double size = std::max({std::abs(y[i]), std::abs(constant[i]), floor});
            // A component that dies away does so without failing where doubles end.
            sizes[i] = std::max(tolerance_ * (size > 0 ? size : 1), 1e-300);
        }
    };

    double before = 0;
    bool isRough = false;  // the matrix contracts slowly
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        problem.slope(t, y, slope);
        ++counts.evaluations;
        if (!allFinite(slope)) return "the slope is not finite";
        if (iteration == 0) isOld = matrix_.exists() && matrixG_ == g;
        if ((iteration == 0 && !isOld) || isRough) {
            if (std::string why = makeMatrix(problem, t, g, y, slope, counts); !why.empty()) return why;
        }
        for (std::size_t i = 0; i < n; ++i) correction[i] = (constant[i] - y[i]) / g + slope[i];
        measure();
        matrix_.rowSizes(sizes, rows);
        const bool isResidualSmall = weightedSize(correction, rows) <= 1;
        matrix_.solve(correction);
        ++counts.newtonIterations;
        const double size = weightedSize(correction, sizes);
        if (!std::isfinite(size)) return "a correction of Newton's method is not finite";
        for (std::size_t i = 0; i < n; ++i) y[i] += correction[i];
        if (size <= 1 && isResidualSmall) return "";
        if (iteration > 0 && size > before / 2) return "Newton's method does not contract";
        isRough = iteration > 0 && size > before / 10;
        before = size;
    }
    return "Newton's method did not converge in " + std::to_string(mostIterations) + " iterations";
}

std::string ImplicitStage::solve(const OdeProblem& problem, double t, double g, std::span<const double> constant,
                                 std::span<double> y, OdeCounts& counts) {
    const std::vector<double> guess(y.begin(), y.end());
    bool isOld = false;
    std::string why = attempt(problem, t, g, constant, y, counts, isOld);
    if (!why.empty() && isOld) {  // with another step's matrix: once more with one of its own
        matrixG_ = 0;
        std::ranges::copy(guess, y.begin());
        why = attempt(problem, t, g, constant, y, counts, isOld);
    }
    if (!why.empty()) matrixG_ = 0;
    return why;
}

}  // namespace mv
