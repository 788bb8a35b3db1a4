#include "mv/motion/radau_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mv/motion/ode_method.h"

namespace mv {

RadauStep::RadauStep(const RadauTolerance& tolerance, std::size_t dimension)
    : tolerance_(tolerance),
      first_(dimension),
      weights_(dimension),
      argument_(dimension),
      error_(dimension),
      filtered_(dimension),
      pair_(dimension) {
    for (auto* vectors : {&stages_, &transformed_, &slopes_, &before_}) {
        for (auto& vector : *vectors) vector.resize(dimension);
    }
}

void RadauStep::weigh(const OdeProblem& problem, std::span<const double> y) {
    if (tolerance_.absolute > 0) {
        for (std::size_t i = 0; i < y.size(); ++i) {
            weights_[i] = tolerance_.absolute + tolerance_.relative * std::abs(y[i]);
        }
        return;
    }
    double largest = 0;
    for (const double component : y) largest = std::max(largest, std::abs(component));
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double size = std::max(std::abs(y[i]), problem.scale.empty() ? 1e-3 * largest : problem.scale[i]);
        weights_[i] = std::max(tolerance_.relative * (size > 0 ? size : 1), 1e-300);
    }
}

double RadauStep::weighted(std::span<const double> x) const {
    double size = 0;
    for (std::size_t i = 0; i < x.size(); ++i) size = std::max(size, std::abs(x[i]) / weights_[i]);
    return size;
}

// The stages by the polynomial of the step before; all y where there is none.
void RadauStep::guess(double h) {
    const RadauCoefficients& r = radauCoefficients();
    const std::size_t n = first_.size();
    if (lastStep_ == 0) {
        for (auto* vectors : {&stages_, &transformed_}) {
            for (auto& vector : *vectors) std::ranges::fill(vector, 0);
        }
        return;
    }
    const double ratio = h / lastStep_;
    for (std::size_t s = 0; s < 3; ++s) {
        const double x = r.c[s] * ratio, toSecond = x - (r.c[1] - 1), toFirst = x - (r.c[0] - 1);
        for (std::size_t i = 0; i < n; ++i) {
            stages_[s][i] = x * (before_[0][i] + toSecond * (before_[1][i] + toFirst * before_[2][i]));
        }
    }
    for (std::size_t s = 0; s < 3; ++s) {
        const auto& row = r.inverse[s];
        for (std::size_t i = 0; i < n; ++i) {
            transformed_[s][i] = row[0] * stages_[0][i] + row[1] * stages_[1][i] + row[2] * stages_[2][i];
        }
    }
}

std::string RadauStep::iterate(const OdeProblem& problem, double t, double h, std::span<const double> y,
                               OdeCounts& counts) {
    const RadauCoefficients& r = radauCoefficients();
    const std::size_t n = y.size();
    const double real = r.real / h;
    const std::complex<double> complex = r.complex / h;
    guess(h);
    // The error that the last step left; a little more, since that was another one.
    remaining_ = std::pow(std::max(remaining_, std::numeric_limits<double>::epsilon()), 0.8);
    double before = 0, ratioBefore = 0;
    rate_ = fastEnough;
    for (iterations_ = 1;; ++iterations_) {
        for (std::size_t s = 0; s < 3; ++s) {
            for (std::size_t i = 0; i < n; ++i) argument_[i] = y[i] + stages_[s][i];
            problem.slope(t + r.c[s] * h, argument_, slopes_[s]);
            ++counts.evaluations;
            if (!allFinite(slopes_[s])) return notFinite;
        }
        // A correction w solves (real - J) w0 = (T^-1 f)_0 - real (T^-1 z)_0, and so do the other two with `complex`.
        for (std::size_t i = 0; i < n; ++i) {
            std::array<double, 3> f{};
            for (std::size_t s = 0; s < 3; ++s) {
                const auto& row = r.inverse[s];
                f[s] = row[0] * slopes_[0][i] + row[1] * slopes_[1][i] + row[2] * slopes_[2][i];
            }
            const double w1 = transformed_[1][i], w2 = transformed_[2][i];
            slopes_[0][i] = f[0] - real * transformed_[0][i];
            pair_[i] = {f[1] - complex.real() * w1 + complex.imag() * w2,
                        f[2] - complex.real() * w2 - complex.imag() * w1};
        }
        matrix_.solve(slopes_[0]);
        matrix_.solve(pair_);
        ++counts.newtonIterations;
        double size = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double w0 = slopes_[0][i], w1 = pair_[i].real(), w2 = pair_[i].imag();
            const double largest = std::max({std::abs(w0), std::abs(w1), std::abs(w2)}) / weights_[i];
            size = largest <= size ? size : largest;  // NaN stays
            transformed_[0][i] += w0;
            transformed_[1][i] += w1;
            transformed_[2][i] += w2;
            for (std::size_t s = 0; s < 3; ++s) {
                const auto& row = r.transform[s];
                stages_[s][i] = row[0] * transformed_[0][i] + row[1] * transformed_[1][i] + row[2] * transformed_[2][i];
            }
        }
        if (!std::isfinite(size)) return "a correction of Newton's method is not finite";
        if (iterations_ > 1) {
            const double ratio = size / before;
            rate_ = iterations_ == 2 ? ratio : std::sqrt(ratio * ratioBefore);
            ratioBefore = ratio;
            if (!(rate_ < 0.99)) return "Newton's method does not contract";
            remaining_ = rate_ / (1 - rate_);
            const int left = tolerance_.mostIterations - 1 - iterations_;
            if (remaining_ * size * std::pow(rate_, left) > tolerance_.newton) {
                return "Newton's method contracts too slowly";
            }
        }
        if (remaining_ * size <= tolerance_.newton) return "";
        if (iterations_ == tolerance_.mostIterations) return "Newton's method did not converge";
        before = std::max(size, std::numeric_limits<double>::epsilon());
    }
}

void RadauStep::estimate(const OdeProblem& problem, double t, double h, std::span<const double> y, OdeCounts& counts) {
    const RadauCoefficients& r = radauCoefficients();
    const std::size_t n = y.size();
    for (std::size_t i = 0; i < n; ++i) {
        filtered_[i] = (r.error[0] * stages_[0][i] + r.error[1] * stages_[1][i] + r.error[2] * stages_[2][i]) / h;
        error_[i] = filtered_[i] + first_[i];
    }
    matrix_.solve(error_);
    // The estimate of a stiff problem is too large on the first step and after a rejection, when y is off its slow
    // course: once more from there, which forgets it.
    if (weighted(error_) < 1 || !(isFirstStep_ || isRepeated_)) return;
    for (std::size_t i = 0; i < n; ++i) argument_[i] = y[i] + error_[i];
    problem.slope(t, argument_, error_);
    ++counts.evaluations;
    for (std::size_t i = 0; i < n; ++i) error_[i] += filtered_[i];
    matrix_.solve(error_);
}

std::string RadauStep::step(const OdeProblem& problem, double t, double h, std::span<const double> y,
                            std::span<double> next, OdeCounts& counts) {
    if (!hasFirst_) {
        problem.slope(t, y, first_);
        ++counts.evaluations;
        if (!allFinite(first_)) return notFinite;
        hasFirst_ = true;
    }
    const bool mayKeep = matrix_.exists() && keepsJacobian() && !isRepeated_;
    if (!isCurrent_ && !mayKeep) {
        if (!matrix_.evaluate(problem, t, y, first_, h, counts)) return "the Jacobian is not finite";
        isCurrent_ = true;
    }
    weigh(problem, y);
    const RadauCoefficients& r = radauCoefficients();
    std::string why;
    if (!matrix_.factorize(r.real / h, counts) || !matrix_.factorize(r.complex / h, counts)) {
        why = "a matrix of the step is singular";
        isCurrent_ = false;
    } else {
        why = iterate(problem, t, h, y, counts);
    }
    if (why.empty()) {
        for (std::size_t i = 0; i < y.size(); ++i) next[i] = y[i] + stages_[2][i];
        estimate(problem, t, h, y, counts);
        if (!allFinite(next) || !allFinite(error_)) why = notFinite;
    }
    isRepeated_ = true;  // unless it is accepted
    takenStep_ = h;
    return why;
}

void RadauStep::accept() {
    const RadauCoefficients& r = radauCoefficients();
    for (std::size_t i = 0; i < first_.size(); ++i) {
        const double z0 = stages_[0][i], z1 = stages_[1][i], z2 = stages_[2][i];
        // Newton's divided differences at c0, c1 and 1, in the time from the end.
        const double last = (z1 - z2) / (r.c[1] - 1), middle = (z0 - z1) / (r.c[0] - r.c[1]);
        const double start = (middle - z0 / r.c[0]) / r.c[1], second = (middle - last) / (r.c[0] - 1);
        before_[0][i] = last;
        before_[1][i] = second;
        before_[2][i] = second - start;
    }
    lastStep_ = takenStep_;
    hasFirst_ = isCurrent_ = isRepeated_ = isFirstStep_ = false;
}

void RadauStep::dense(double, std::span<const double> y, std::span<const double>,
                      std::array<std::vector<double>, 3>& vectors) const {
    const RadauCoefficients& r = radauCoefficients();
    for (auto& vector : vectors) vector.assign(y.size(), 0);
    for (std::size_t i = 0; i < y.size(); ++i) {
        // x d + x (1 - x) (a + b x) goes through the stages.
        const auto inner = [&](std::size_t s) {
            return (stages_[s][i] - r.c[s] * stages_[2][i]) / (r.c[s] * (1 - r.c[s]));
        };
        vectors[1][i] = (inner(1) - inner(0)) / (r.c[1] - r.c[0]);
        vectors[0][i] = inner(0) - r.c[0] * vectors[1][i];
    }
}

}  // namespace mv
