#include "mv/motion/iteration_matrix.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "mv/error.h"
#include "mv/motion/linear_factors.h"

namespace mv {
namespace {

using Complex = std::complex<double>;

bool isAtSamePlaces(const std::vector<MatrixEntry>& a, const std::vector<MatrixEntry>& b) {
    return std::ranges::equal(
        a, b, [](const MatrixEntry& x, const MatrixEntry& y) { return x.row == y.row && x.column == y.column; });
}

// Which row and column of the matrix is the i-th to be eliminated, so that neighbours in the graph of the entries stay
// near each other. Source: Cuthill and McKee, "Reducing the bandwidth of sparse symmetric matrices" (1969).
std::vector<std::size_t> cuthillMcKee(std::size_t n, const std::vector<MatrixEntry>& entries) {
    std::vector<std::vector<std::size_t>> neighbours(n);
    for (const MatrixEntry& entry : entries) {
        if (entry.row == entry.column) continue;
        const auto row = static_cast<std::size_t>(entry.row), column = static_cast<std::size_t>(entry.column);
        neighbours[row].push_back(column);
        neighbours[column].push_back(row);
    }
    for (auto& list : neighbours) {
        std::ranges::sort(list);
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    const auto hasFewer = [&](std::size_t a, std::size_t b) { return neighbours[a].size() < neighbours[b].size(); };
    for (auto& list : neighbours) std::ranges::stable_sort(list, hasFewer);

    std::vector<std::size_t> order, starts(n);
    std::vector<bool> isTaken(n);
    for (std::size_t i = 0; i < n; ++i) starts[i] = i;
    std::ranges::stable_sort(starts, hasFewer);
    for (const std::size_t start : starts) {  // one for each part that hangs together
        if (isTaken[start]) continue;
        isTaken[start] = true;
        order.push_back(start);
        for (std::size_t next = order.size() - 1; next < order.size(); ++next) {
            for (const std::size_t neighbour : neighbours[order[next]]) {
                if (isTaken[neighbour]) continue;
                isTaken[neighbour] = true;
                order.push_back(neighbour);
            }
        }
    }
    return order;
}

// s I - J factorized, real or complex.
template <typename T>
struct Factors {
    std::optional<T> s;  // of what is factorized
    LinearFactors<T> of;
};

}  // namespace

struct IterationMatrix::Parts {
    std::size_t dimension = 0;
    bool isSparse = false;
    // One of the two.
    std::vector<double> denseJacobian;
    std::vector<MatrixEntry> entries, entriesBefore;

    std::vector<std::size_t> places;  // of a sparse one: where each row and column stands in its order
    std::size_t lower = 0, upper = 0;
    Factors<double> real;
    Factors<Complex> complex;

    template <typename T>
    Factors<T>& factors() {
        if constexpr (std::is_same_v<T, double>) {
            return real;
        } else {
            return complex;
        }
    }

    void chooseOrder();
    template <typename T>
    bool factorize(T shift);
    template <typename T>
    void solve(std::span<T> x, std::vector<T>& ordered);
};

void IterationMatrix::Parts::chooseOrder() {
    const std::vector<std::size_t> order = cuthillMcKee(dimension, entries);
    places.resize(dimension);
    for (std::size_t i = 0; i < dimension; ++i) places[order[i]] = i;
    lower = upper = 0;
    for (const MatrixEntry& entry : entries) {
        const std::size_t row = places[static_cast<std::size_t>(entry.row)];
        const std::size_t column = places[static_cast<std::size_t>(entry.column)];
        lower = std::max(lower, row > column ? row - column : 0);
        upper = std::max(upper, column > row ? column - row : 0);
    }
}

template <typename T>
bool IterationMatrix::Parts::factorize(T shift) {
    LinearFactors<T>& into = factors<T>().of;
    const std::size_t n = dimension;
    if (isSparse) {
        into.reset(n, lower, upper);
        for (const MatrixEntry& entry : entries) {
            into.at(places[static_cast<std::size_t>(entry.row)], places[static_cast<std::size_t>(entry.column)]) -=
                entry.value;
        }
    } else {
        into.reset(n, n - 1, n - 1);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) into.at(i, j) = T(-denseJacobian[i * n + j]);
        }
    }
    for (std::size_t i = 0; i < n; ++i) into.at(i, i) += shift;
    return into.factorize();
}

template <typename T>
void IterationMatrix::Parts::solve(std::span<T> x, std::vector<T>& ordered) {
    const LinearFactors<T>& by = factors<T>().of;
    if (!isSparse) return by.solve(x);
    ordered.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) ordered[places[i]] = x[i];
    by.solve(ordered);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = ordered[places[i]];
}

bool IterationMatrix::evaluate(const OdeProblem& problem, double t, std::span<const double> y,
                               std::span<const double> slope, double span, OdeCounts& counts) {
    if (!parts_) {
        parts_ = std::make_shared<Parts>();
    } else if (parts_.use_count() > 1) {
        parts_ = std::make_shared<Parts>(*parts_);
    }
    Parts& parts = *parts_;
    parts.real.s.reset();
    parts.complex.s.reset();
    parts.dimension = problem.dimension;
    ++counts.jacobians;

    bool isFinite = true;
    if (problem.sparseJacobian) {
        parts.entries.swap(parts.entriesBefore);
        parts.entries.clear();
        problem.sparseJacobian(t, y, parts.entries);
        const int n = static_cast<int>(problem.dimension);
        for (const MatrixEntry& entry : parts.entries) {
            if (entry.row < 0 || entry.row >= n || entry.column < 0 || entry.column >= n) {
                throw Error("sparseJacobian", "rows and columns must be 0 to " + std::to_string(n - 1),
                            "(" + std::to_string(entry.row) + ", " + std::to_string(entry.column) + ")");
            }
            isFinite = isFinite && std::isfinite(entry.value);
        }
        if (!parts.isSparse || !isAtSamePlaces(parts.entries, parts.entriesBefore)) parts.chooseOrder();
        parts.isSparse = true;
    } else {
        parts.isSparse = false;
        parts.denseJacobian.assign(problem.dimension * problem.dimension, 0);
        if (problem.jacobian) {
            problem.jacobian(t, y, parts.denseJacobian);
        } else {
            parts.denseJacobian = differencedJacobian(problem, t, y, slope, span, counts.evaluations);
        }
        isFinite = allFinite(parts.denseJacobian);
    }
    if (!isFinite) parts_.reset();
    return isFinite;
}

template <typename T>
bool IterationMatrix::factorizeAt(T s, OdeCounts& counts) {
    if (parts_->factors<T>().s == s) return true;
    if (parts_.use_count() > 1) parts_ = std::make_shared<Parts>(*parts_);
    ++counts.factorizations;
    if (!parts_->factorize(s)) {
        parts_.reset();
        return false;
    }
    parts_->factors<T>().s = s;
    return true;
}

bool IterationMatrix::factorize(double s, OdeCounts& counts) { return factorizeAt(s, counts); }
bool IterationMatrix::factorize(Complex s, OdeCounts& counts) { return factorizeAt(s, counts); }
void IterationMatrix::solve(std::span<double> x) const { parts_->solve(x, ordered_); }
void IterationMatrix::solve(std::span<Complex> x) const { parts_->solve(x, complexOrdered_); }

void IterationMatrix::rowSizes(std::span<const double> w, std::span<double> result) const {
    const double s = parts_->real.s.value();
    const std::size_t n = parts_->dimension;
    if (parts_->isSparse) {
        // Row sums of absolute values: entries of one place are few, and the sum of their sizes will do.
        for (std::size_t i = 0; i < n; ++i) result[i] = std::abs(s) * w[i];
        for (const MatrixEntry& entry : parts_->entries) {
            result[static_cast<std::size_t>(entry.row)] +=
                std::abs(entry.value) * w[static_cast<std::size_t>(entry.column)];
        }
        return;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double* row = parts_->denseJacobian.data() + i * n;
        result[i] = std::abs(s) * w[i];
        for (std::size_t j = 0; j < n; ++j) result[i] += std::abs(row[j]) * w[j];
    }
}

}  // namespace mv
