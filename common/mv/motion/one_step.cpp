#include "mv/motion/one_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mv {

RungeKuttaStep::RungeKuttaStep(const ButcherTableau& tableau, std::size_t dimension)
    : tableau_(&tableau),
      slopes_(static_cast<std::size_t>(tableau.stages), std::vector<double>(dimension)),
      stage_(dimension),
      error_(tableau.error.empty() ? 0 : dimension) {
    const int last = tableau.stages - 1;
    isFirstSameAsLast_ = last > 0 && tableau.c.back() == 1;
    for (int j = 0; j <= last; ++j) {
        isFirstSameAsLast_ = isFirstSameAsLast_ && tableau.element(last, j) == tableau.b[static_cast<std::size_t>(j)];
    }
}

std::string RungeKuttaStep::step(const OdeProblem& problem, double t, double h, std::span<const double> y,
                                 std::span<double> next, OdeCounts& counts) {
    const std::size_t n = y.size();
    for (int s = hasFirst_ ? 1 : 0; s < tableau_->stages; ++s) {
        const auto row = static_cast<std::size_t>(s);
        std::ranges::copy(y, stage_.begin());
        for (int j = 0; j < s; ++j) {
            const double a = tableau_->element(s, j);
            if (a == 0) continue;
            const std::vector<double>& slope = slopes_[static_cast<std::size_t>(j)];
            for (std::size_t i = 0; i < n; ++i) stage_[i] += h * a * slope[i];
        }
        problem.slope(t + tableau_->c[row] * h, stage_, slopes_[row]);
        ++counts.evaluations;
        if (!allFinite(slopes_[row])) return notFinite;
        if (s == 0) hasFirst_ = true;
    }
    std::ranges::copy(y, next.begin());
    std::ranges::fill(error_, 0);
    for (int s = 0; s < tableau_->stages; ++s) {
        const auto row = static_cast<std::size_t>(s);
        const double b = tableau_->b[row];
        for (std::size_t i = 0; i < n; ++i) next[i] += h * b * slopes_[row][i];
        if (error_.empty()) continue;
        const double e = tableau_->error[row];
        for (std::size_t i = 0; i < n; ++i) error_[i] += h * e * slopes_[row][i];
    }
    return allFinite(next) && allFinite(error_) ? "" : notFinite;
}

void RungeKuttaStep::accept() {
    if (isFirstSameAsLast_) {
        std::swap(slopes_.front(), slopes_.back());
    } else {
        hasFirst_ = false;
    }
}

void RungeKuttaStep::dense(double h, std::span<const double> y, std::span<const double> next,
                           std::array<std::vector<double>, 3>& vectors) const {
    // Source: Hairer, Norsett and Wanner I, II.6; their code DOPRI5. A method of order 4.
    static constexpr std::array<double, 7> d{-12715105075.0 / 11282082432,  0,
                                             87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
                                             701980252875.0 / 199316789632, -1453857185.0 / 822651844,
                                             69997945.0 / 29380423};
    for (auto& vector : vectors) vector.assign(y.size(), 0);
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double difference = next[i] - y[i];
        vectors[0][i] = h * slopes_.front()[i] - difference;
        vectors[1][i] = difference - h * slopes_.back()[i] - vectors[0][i];
        for (std::size_t s = 0; s < d.size(); ++s) vectors[2][i] += h * d[s] * slopes_[s][i];
    }
}

RosenbrockStep::RosenbrockStep(const RosenbrockCoefficients& coefficients, std::size_t dimension)
    : coefficients_(&coefficients), first_(dimension), timeSlope_(dimension), stage_(dimension) {
    for (auto& u : u_) u.resize(dimension);
}

std::string RosenbrockStep::start(const OdeProblem& problem, double t, double h, std::span<const double> y,
                                  OdeCounts& counts) {
    problem.slope(t, y, first_);
    ++counts.evaluations;
    if (!allFinite(first_)) return notFinite;
    if (!matrix_.evaluate(problem, t, y, first_, h, counts)) return "the Jacobian is not finite";
    if (!problem.isAutonomous) {
        const double later = t + std::sqrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(t), h);
        problem.slope(later, y, timeSlope_);
        ++counts.evaluations;
        for (std::size_t i = 0; i < y.size(); ++i) timeSlope_[i] = (timeSlope_[i] - first_[i]) / (later - t);
        if (!allFinite(timeSlope_)) return notFinite;
    }
    hasFirst_ = true;
    return "";
}

std::string RosenbrockStep::step(const OdeProblem& problem, double t, double h, std::span<const double> y,
                                 std::span<double> next, OdeCounts& counts) {
    const std::size_t n = y.size();
    if (!hasFirst_) {
        if (std::string why = start(problem, t, h, y, counts); !why.empty()) return why;
    }
    if (!matrix_.factorize(1 / (h * coefficients_->gamma), counts)) {
        hasFirst_ = false;
        return "the matrix of the step is singular";
    }
    for (std::size_t s = 0; s < u_.size(); ++s) {
        std::vector<double>& u = u_[s];
        if (s == 0) {
            u = first_;
        } else {
            std::ranges::copy(y, stage_.begin());
            for (std::size_t j = 0; j < s; ++j) {
                const double a = coefficients_->a[s][j];
                for (std::size_t i = 0; i < n; ++i) stage_[i] += a * u_[j][i];
            }
            problem.slope(t + coefficients_->alpha[s] * h, stage_, u);
            ++counts.evaluations;
            for (std::size_t j = 0; j < s; ++j) {
                const double c = coefficients_->c[s][j] / h;
                for (std::size_t i = 0; i < n; ++i) u[i] += c * u_[j][i];
            }
        }
        const double d = h * coefficients_->d[s];
        if (d != 0 && !problem.isAutonomous) {
            for (std::size_t i = 0; i < n; ++i) u[i] += d * timeSlope_[i];
        }
        if (!allFinite(u)) return notFinite;
        matrix_.solve(u);
    }
    std::ranges::copy(y, next.begin());
    for (std::size_t s = 0; s < u_.size(); ++s) {
        for (std::size_t i = 0; i < n; ++i) next[i] += coefficients_->m[s] * u_[s][i];
    }
    return allFinite(next) && allFinite(u_.back()) ? "" : notFinite;
}

void RosenbrockStep::dense(double, std::span<const double> y, std::span<const double>,
                           std::array<std::vector<double>, 3>& vectors) const {
    for (auto& vector : vectors) vector.assign(y.size(), 0);
    for (std::size_t c = 0; c < 2; ++c) {
        for (std::size_t s = 0; s + 1 < u_.size(); ++s) {
            for (std::size_t i = 0; i < y.size(); ++i) vectors[c][i] += coefficients_->dense[c][s] * u_[s][i];
        }
    }
}

}  // namespace mv
