#include "mv/motion/iteration_matrix.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "mv/error.h"
#include "mv/motion/linear_factors.h"

namespace mv {
namespace {

using Complex = std::complex<double>;
template <typename T>
using DenseMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
template <typename T>
using SparseMatrix = Eigen::SparseMatrix<T>;
template <typename T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;

// Up to here LinearFactors is faster than Eigen.
constexpr std::size_t mostSmall = 32;
// Diagonals on one side, up to which a band is faster than SparseLU, which looks up where each entry lies.
constexpr std::size_t widestBand = 24;

enum class Structure { small, dense, band, sparse };

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
    // One of the three.
    LinearFactors<T> small;  // and bands
    Eigen::PartialPivLU<DenseMatrix<T>> dense;
    std::optional<Eigen::SparseLU<SparseMatrix<T>>> sparse;

    bool hasOrder = false;  // of the sparse one, which stays while the pattern does
};

}  // namespace

struct IterationMatrix::Parts {
    std::size_t dimension = 0;
    Structure structure = Structure::small;
    // One of the two.
    std::vector<double> denseJacobian;
    std::vector<MatrixEntry> entries, entriesBefore;

    std::vector<std::size_t> places;  // of a band: where each row and column stands in its order
    std::size_t lower = 0, upper = 0;
    Factors<double> real;
    Factors<Complex> complex;

    Parts() = default;
    // SparseLU cannot be copied: a copy factorizes for itself.
    Parts(const Parts& other)
        : dimension(other.dimension),
          structure(other.structure),
          denseJacobian(other.denseJacobian),
          entries(other.entries),
          entriesBefore(other.entriesBefore),
          places(other.places),
          lower(other.lower),
          upper(other.upper) {}
    Parts& operator=(const Parts&) = delete;

    bool isSparse() const { return structure == Structure::band || structure == Structure::sparse; }
    template <typename T>
    Factors<T>& factors() {
        if constexpr (std::is_same_v<T, double>) {
            return real;
        } else {
            return complex;
        }
    }

    void chooseStructure();
    template <typename T>
    bool factorize(T shift);
    template <typename T>
    void solve(std::span<T> x, std::vector<T>& ordered);
};

void IterationMatrix::Parts::chooseStructure() {
    real.hasOrder = complex.hasOrder = false;
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
    structure = std::max(lower, upper) <= widestBand ? Structure::band : Structure::sparse;
}

template <typename T>
bool IterationMatrix::Parts::factorize(T shift) {
    Factors<T>& into = factors<T>();
    const std::size_t n = dimension;
    switch (structure) {
        case Structure::small: {
            into.small.reset(n, n - 1, n - 1);
            for (std::size_t i = 0; i < n; ++i) {
                for (std::size_t j = 0; j < n; ++j) into.small.at(i, j) = T(-denseJacobian[i * n + j]);
                into.small.at(i, i) += shift;
            }
            return into.small.factorize();
        }
        case Structure::band: {
            into.small.reset(n, lower, upper);
            for (const MatrixEntry& entry : entries) {
                into.small.at(places[static_cast<std::size_t>(entry.row)],
                              places[static_cast<std::size_t>(entry.column)]) -= entry.value;
            }
            for (std::size_t i = 0; i < n; ++i) into.small.at(i, i) += shift;
            return into.small.factorize();
        }
        case Structure::dense: {
            const auto size = static_cast<Eigen::Index>(n);
            DenseMatrix<T> shifted =
                (-Eigen::Map<const DenseMatrix<double>>(denseJacobian.data(), size, size)).template cast<T>();
            shifted.diagonal().array() += shift;
            into.dense.compute(shifted);
            // A singular matrix has a pivot 0, and one that overflowed has NaN.
            const auto pivots = into.dense.matrixLU().diagonal().array();
            return pivots.isFinite().all() && (pivots != T(0)).all();
        }
        case Structure::sparse: {
            std::vector<Eigen::Triplet<T>> triplets;
            triplets.reserve(entries.size() + n);
            for (const MatrixEntry& entry : entries) triplets.emplace_back(entry.row, entry.column, T(-entry.value));
            for (int i = 0; i < static_cast<int>(n); ++i) triplets.emplace_back(i, i, shift);
            SparseMatrix<T> shifted(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
            shifted.setFromTriplets(triplets.begin(), triplets.end());
            if (!into.sparse) into.sparse.emplace();
            // In which order to eliminate is the pattern's affair, and takes as long as eliminating.
            if (!into.hasOrder) into.sparse->analyzePattern(shifted);
            into.hasOrder = true;
            into.sparse->factorize(shifted);
            return into.sparse->info() == Eigen::Success;
        }
    }
    return false;
}

template <typename T>
void IterationMatrix::Parts::solve(std::span<T> x, std::vector<T>& ordered) {
    Factors<T>& by = factors<T>();
    Eigen::Map<Vector<T>> vector(x.data(), static_cast<Eigen::Index>(x.size()));
    switch (structure) {
        case Structure::small:
            by.small.solve(x);
            return;
        case Structure::band:
            ordered.resize(x.size());
            for (std::size_t i = 0; i < x.size(); ++i) ordered[places[i]] = x[i];
            by.small.solve(ordered);
            for (std::size_t i = 0; i < x.size(); ++i) x[i] = ordered[places[i]];
            return;
        case Structure::dense:
            vector = Vector<T>(by.dense.solve(vector));
            return;
        case Structure::sparse:
            vector = Vector<T>(by.sparse->solve(vector));
            return;
    }
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
        if (!parts.isSparse() || !isAtSamePlaces(parts.entries, parts.entriesBefore)) parts.chooseStructure();
    } else {
        parts.structure = problem.dimension <= mostSmall ? Structure::small : Structure::dense;
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
    if (parts_->isSparse()) {
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
