// The truth: nothing here is shared with what is measured.
#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "mv/error.h"
#include "work_precision/problem.h"

namespace mv::work_precision {
namespace {

// 34 digits: with the 19 of long double the roundings of a stiff spring's ends come through.
using Wide =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<34, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;
using Values = std::vector<Wide>;

// f and df/dy, row by row; without the latter it is taken to be 0, which costs steps and no exactness. `order` says which
// component of the result stands where.
struct WideProblem {
    std::size_t dimension;
    std::function<void(const Values& y, Values& slope)> slope;
    std::function<void(const Values& y, Values& jacobian)> jacobian;
    std::vector<std::size_t> order = {};
};

// ---- the problems, written down a second time

WideProblem robertson() {
    return {3,
            [](const Values& y, Values& f) {
                f[0] = -0.04L * y[0] + 1e4L * y[1] * y[2];
                f[2] = 3e7L * y[1] * y[1];
                f[1] = -f[0] - f[2];
            },
            [](const Values& y, Values& j) {
                j = {-0.04L,       1e4L * y[2], 1e4L * y[1], 0.04L, -1e4L * y[2] - 6e7L * y[1],
                     -1e4L * y[1], 0,           6e7L * y[1], 0};
            }};
}

WideProblem vanDerPol() {
    // The double nearest to 1e-6, and 1/eps rounded as nobody rounds it there.
    static const Wide eps = 1e-6;
    return {2,
            [](const Values& y, Values& f) {
                f[0] = y[1];
                f[1] = ((1 - y[0] * y[0]) * y[1] - y[0]) / eps;
            },
            [](const Values& y, Values& j) {
                j = {0, 1, (-2 * y[0] * y[1] - 1) / eps, (1 - y[0] * y[0]) / eps};
            }};
}

WideProblem hires() {
    return {8,
            [](const Values& y, Values& f) {
                f[0] = -1.71L * y[0] + 0.43L * y[1] + 8.32L * y[2] + 0.0007L;
                f[1] = 1.71L * y[0] - 8.75L * y[1];
                f[2] = -10.03L * y[2] + 0.43L * y[3] + 0.035L * y[4];
                f[3] = 8.32L * y[1] + 1.71L * y[2] - 1.12L * y[3];
                f[4] = -1.745L * y[4] + 0.43L * y[5] + 0.43L * y[6];
                f[5] = -280 * y[5] * y[7] + 0.69L * y[3] + 1.71L * y[4] - 0.43L * y[5] + 0.69L * y[6];
                f[6] = 280 * y[5] * y[7] - 1.81L * y[6];
                f[7] = -f[6];
            },
            [](const Values& y, Values& j) {
                j = {-1.71L, 0.43L,       8.32L,   0,      0,       0,
                     0,      0,  //
                     1.71L,  -8.75L,      0,       0,      0,       0,
                     0,      0,  //
                     0,      0,           -10.03L, 0.43L,  0.035L,  0,
                     0,      0,  //
                     0,      8.32L,       1.71L,   -1.12L, 0,       0,
                     0,      0,  //
                     0,      0,           0,       0,      -1.745L, 0.43L,
                     0.43L,  0,  //
                     0,      0,           0,       0.69L,  1.71L,   -0.43L - 280 * y[7],
                     0.69L,  -280 * y[5],  //
                     0,      0,           0,       0,      0,       280 * y[7],
                     -1.81L, 280 * y[5],  //
                     0,      0,           0,       0,      0,       -280 * y[7],
                     1.81L,  -280 * y[5]};
            }};
}

WideProblem oregonator() {
    return {3,
            [](const Values& y, Values& f) {
                f[0] = 77.27L * (y[1] + y[0] * (1 - 8.375e-6L * y[0] - y[1]));
                f[1] = (y[2] - (1 + y[0]) * y[1]) / 77.27L;
                f[2] = 0.161L * (y[0] - y[2]);
            },
            [](const Values& y, Values& j) {
                j = {77.27L * (1 - 2 * 8.375e-6L * y[0] - y[1]),
                     77.27L * (1 - y[0]),
                     0,  //
                     -y[1] / 77.27L,
                     -(1 + y[0]) / 77.27L,
                     1 / 77.27L,
                     0.161L,
                     0,
                     -0.161L};
            }};
}

WideProblem pleiades() {
    return {28,
            [](const Values& y, Values& f) {
                std::fill(f.begin(), f.end(), 0);
                for (std::size_t i = 0; i < 14; ++i) f[i] = y[14 + i];
                for (std::size_t i = 0; i < 7; ++i) {
                    for (std::size_t j = i + 1; j < 7; ++j) {
                        const Wide dx = y[j] - y[i], dy = y[7 + j] - y[7 + i], r = sqrt(dx * dx + dy * dy);
                        const Wide mi = static_cast<Wide>(i + 1), mj = static_cast<Wide>(j + 1), cube = r * r * r;
                        f[14 + i] += mj * dx / cube, f[14 + j] -= mi * dx / cube;
                        f[21 + i] += mj * dy / cube, f[21 + j] -= mi * dy / cube;
                    }
                }
            },
            {}};
}

// q and v of each mass side by side, so that its matrix is a band: y[2 i] is q of mass i.
WideProblem chain() {
    static constexpr std::size_t n = 100, size = 2 * n;
    // df/dy is constant: mass i is pulled by the springs i and i + 1, of which the odd ones are stiff and damped.
    Values matrix(size * size);
    for (std::size_t i = 0; i < n; ++i) {
        matrix[2 * i * size + 2 * i + 1] = 1;
        Wide* pull = matrix.data() + (2 * i + 1) * size;
        for (const std::size_t spring : {i, i + 1}) {
            const bool isStiff = spring % 2 == 1;
            const Wide stiffness = isStiff ? Wide(1e6) : Wide(1), damping = isStiff ? Wide(1000) : Wide(0);
            pull[2 * i] -= stiffness, pull[2 * i + 1] -= damping;
            const bool isLeft = spring == i;
            if ((isLeft && i == 0) || (!isLeft && i + 1 == n)) continue;
            const std::size_t other = isLeft ? i - 1 : i + 1;
            pull[2 * other] += stiffness, pull[2 * other + 1] += damping;
        }
    }
    WideProblem problem{size,
                        [matrix](const Values& y, Values& f) {
                            for (std::size_t i = 0; i < size; ++i) {
                                f[i] = 0;
                                const std::size_t from = i < 3 ? 0 : i - 3, to = std::min(size, i + 4);
                                for (std::size_t j = from; j < to; ++j) f[i] += matrix[i * size + j] * y[j];
                            }
                        },
                        [matrix](const Values&, Values& j) { j = matrix; }};
    for (std::size_t i = 0; i < n; ++i) {
        problem.order.push_back(2 * i);
    }
    for (std::size_t i = 0; i < n; ++i) {
        problem.order.push_back(2 * i + 1);
    }
    return problem;
}

// ---- linear systems

// Elimination with row exchanges of a dense matrix, of which a band may be filled.
class Elimination {
  public:
    Elimination(Values matrix, std::size_t n) : n_(n), m_(std::move(matrix)), pivots_(n) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                if (m_[i * n + j] == 0) continue;
                below_ = std::max(below_, i > j ? i - j : 0);
                right_ = std::max(right_, j > i ? j - i : 0);
            }
        }
        right_ += below_;  // by exchanges
        for (std::size_t k = 0; k < n; ++k) {
            std::size_t pivot = k;
            for (std::size_t i = k + 1; i < bottom(k); ++i) {
                if (abs(m_[i * n + k]) > abs(m_[pivot * n + k])) pivot = i;
            }
            pivots_[k] = pivot;
            for (std::size_t j = k; j < right(k); ++j) std::swap(m_[k * n + j], m_[pivot * n + j]);
            for (std::size_t i = k + 1; i < bottom(k); ++i) {
                const Wide factor = m_[i * n + k] /= m_[k * n + k];
                if (factor == 0) continue;
                for (std::size_t j = k + 1; j < right(k); ++j) m_[i * n + j] -= factor * m_[k * n + j];
            }
        }
    }
    void solve(Values& x) const {
        for (std::size_t k = 0; k < n_; ++k) {
            std::swap(x[k], x[pivots_[k]]);
            for (std::size_t i = k + 1; i < bottom(k); ++i) x[i] -= m_[i * n_ + k] * x[k];
        }
        for (std::size_t k = n_; k-- > 0;) {
            for (std::size_t j = k + 1; j < right(k); ++j) x[k] -= m_[k * n_ + j] * x[j];
            x[k] /= m_[k * n_ + k];
        }
    }

  private:
    std::size_t bottom(std::size_t k) const { return std::min(n_, k + below_ + 1); }
    std::size_t right(std::size_t k) const { return std::min(n_, k + right_ + 1); }
    std::size_t n_, below_ = 0, right_ = 0;
    Values m_;
    std::vector<std::size_t> pivots_;
};

// ---- extrapolation

constexpr std::size_t columns = 12;

// y after a step h by linearly implicit Euler in 2, 3, 4 ... parts, extrapolated; and the change by the last column, in
// parts of each component's size.
double extrapolated(const WideProblem& problem, const Values& y, const Wide& h, const Values& jacobian, double floor,
                    Values& next) {
    const std::size_t n = problem.dimension;
    std::array<Values, columns> table;  // the last row, from the left
    Values slope(n);
    double error = 0;
    for (std::size_t row = 0; row < columns; ++row) {
        const auto parts = static_cast<Wide>(row + 2);
        Values matrix(n * n), at = y;
        const bool isImplicit = !jacobian.empty();
        for (std::size_t i = 0; isImplicit && i < n * n; ++i) matrix[i] = -jacobian[i];
        for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] += parts / h;
        const Elimination factors(isImplicit ? matrix : Values(1, 1), isImplicit ? n : 1);
        for (std::size_t part = 0; part < row + 2; ++part) {
            problem.slope(at, slope);
            if (isImplicit) {
                factors.solve(slope);
                for (std::size_t i = 0; i < n; ++i) at[i] += slope[i];
            } else {
                for (std::size_t i = 0; i < n; ++i) at[i] += h / parts * slope[i];
            }
        }
        for (std::size_t k = 0; k <= row; ++k) {
            std::swap(table[k], at);  // `at` is now what stood there in the row before
            if (k == row) break;
            const Wide ratio = parts / static_cast<Wide>(row + 1 - k);
            Values better(n);
            for (std::size_t i = 0; i < n; ++i) better[i] = table[k][i] + (table[k][i] - at[i]) / (ratio - 1);
            std::swap(at, better);
            // In the next column stands the last row's; `at` goes there.
        }
    }
    next = table[columns - 1];
    for (std::size_t i = 0; i < n; ++i) {
        const double size = std::max({static_cast<double>(abs(next[i])), static_cast<double>(abs(y[i])), floor});
        const double change = static_cast<double>(abs(next[i] - table[columns - 2][i])) / size;
        error = std::isfinite(change) ? std::max(error, change) : HUGE_VAL;
    }
    return error;
}

States solved(const WideProblem& problem, const Problem& of) {
    constexpr double tolerance = 1e-16;
    const std::size_t n = problem.dimension;
    Values y(n), next(n), jacobian;
    const auto place = [&](std::size_t i) { return problem.order.empty() ? i : problem.order[i]; };
    for (std::size_t i = 0; i < n; ++i) y[place(i)] = of.ode.initial[i];
    States states;
    Wide t = 0, h = 1e-3 * of.stops.front();
    for (const double stop : of.stops) {
        while (t < stop) {
            const bool isLast = t + h * 1.01L >= stop;
            const Wide length = isLast ? stop - t : h;
            if (problem.jacobian) {
                jacobian.resize(n * n);
                problem.jacobian(y, jacobian);
            }
            const double error = extrapolated(problem, y, length, jacobian, of.floor, next);
            const double factor =
                std::clamp(0.8 * std::pow(tolerance / std::max(error, 1e-25), 1.0 / columns), 0.1, 4.0);
            if (error <= tolerance) {
                y = next;
                t = isLast ? static_cast<Wide>(stop) : t + length;
                h = isLast ? std::max(h, length * factor) : length * factor;
            } else {
                h = length * std::min(factor, 0.7);
                if (h < 1e-18L * stop) throw Error("reference", "must be reached", of.ode.name);
            }
        }
        std::vector<double> state(n);
        for (std::size_t i = 0; i < n; ++i) state[i] = static_cast<double>(y[place(i)]);
        states.push_back(std::move(state));
    }
    return states;
}

// w = 1 and the damping ratio.
States springStates(const Problem& of, long double ratio) {
    States states;
    const long double damped = sqrtl(1 - ratio * ratio);
    for (const double stop : of.stops) {
        const long double shrunk = std::exp(-ratio * stop), c = std::cos(damped * stop), s = std::sin(damped * stop);
        states.push_back(
            {static_cast<double>(shrunk * (c + ratio / damped * s)), static_cast<double>(-shrunk / damped * s)});
    }
    return states;
}

}  // namespace

States computedReference(const Problem& problem) {
    const std::string& name = problem.ode.name;
    if (name == "undamped spring") return springStates(problem, 0);
    if (name == "damped spring") return springStates(problem, 0.1L);
    if (name == "stiff chain") return solved(chain(), problem);
    if (name == "Robertson") return solved(robertson(), problem);
    if (name == "van der Pol") return solved(vanDerPol(), problem);
    if (name == "HIRES") return solved(hires(), problem);
    if (name == "Oregonator") return solved(oregonator(), problem);
    if (name == "Pleiades") return solved(pleiades(), problem);
    throw Error("computedReference", "must be of a problem of odeCases", name);
}

}  // namespace mv::work_precision
