#include "mv/motion/iteration_matrix.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mv/error.h"

namespace mv {
namespace {

using DenseMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using SparseMatrix = Eigen::SparseMatrix<double>;

bool hasSamePattern(const SparseMatrix& a, const SparseMatrix& b) {
    return a.nonZeros() == b.nonZeros() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace

struct IterationMatrix::Parts {
    Eigen::Index dimension = 0;
    bool isSparse = false;
    std::optional<double> s;  // of what is factorized
    // One of the two.
    DenseMatrix denseJacobian;
    std::vector<MatrixEntry> entries;

    Eigen::PartialPivLU<DenseMatrix> denseFactors;
    SparseMatrix matrix;
    Eigen::SparseLU<SparseMatrix> sparseFactors;

    Parts() = default;
    // SparseLU cannot be copied: a copy factorizes for itself.
    Parts(const Parts& other)
        : dimension(other.dimension),
          isSparse(other.isSparse),
          denseJacobian(other.denseJacobian),
          entries(other.entries) {}
    Parts& operator=(const Parts&) = delete;

    bool factorizeDense(double shift);
    bool factorizeSparse(double shift);
};

bool IterationMatrix::Parts::factorizeDense(double shift) {
    DenseMatrix shifted = -denseJacobian;
    shifted.diagonal().array() += shift;
    denseFactors.compute(shifted);
    // A singular matrix has a pivot 0, and one that overflowed has NaN.
    const auto pivots = denseFactors.matrixLU().diagonal().array();
    return pivots.isFinite().all() && (pivots != 0).all();
}

bool IterationMatrix::Parts::factorizeSparse(double shift) {
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(entries.size() + static_cast<std::size_t>(dimension));
    for (const MatrixEntry& entry : entries) triplets.emplace_back(entry.row, entry.column, -entry.value);
    for (int i = 0; i < static_cast<int>(dimension); ++i) triplets.emplace_back(i, i, shift);
    SparseMatrix shifted(dimension, dimension);
    shifted.setFromTriplets(triplets.begin(), triplets.end());
    // In which order to eliminate is the pattern's affair, and takes as long as eliminating.
    if (!hasSamePattern(shifted, matrix)) sparseFactors.analyzePattern(shifted);
    matrix.swap(shifted);
    sparseFactors.factorize(matrix);
    return sparseFactors.info() == Eigen::Success;
}

bool IterationMatrix::evaluate(const OdeProblem& problem, double t, std::span<const double> y,
                               std::span<const double> slope, double span, OdeCounts& counts) {
    if (!parts_ || parts_.use_count() > 1) parts_ = std::make_shared<Parts>();
    Parts& parts = *parts_;
    parts.s.reset();
    parts.dimension = static_cast<Eigen::Index>(problem.dimension);
    parts.isSparse = problem.sparseJacobian != nullptr;
    ++counts.jacobians;

    bool isFinite = true;
    if (parts.isSparse) {
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
    } else {
        parts.denseJacobian.setZero(parts.dimension, parts.dimension);
        if (problem.jacobian) {
            problem.jacobian(t, y, {parts.denseJacobian.data(), problem.dimension * problem.dimension});
        } else {
            const std::vector<double> differenced = differencedJacobian(problem, t, y, slope, span, counts.evaluations);
            std::ranges::copy(differenced, parts.denseJacobian.data());
        }
        isFinite = parts.denseJacobian.allFinite();
    }
    if (!isFinite) parts_.reset();
    return isFinite;
}

bool IterationMatrix::factorize(double s, OdeCounts& counts) {
    if (parts_->s == s) return true;
    if (parts_.use_count() > 1) parts_ = std::make_shared<Parts>(*parts_);
    ++counts.factorizations;
    if (!(parts_->isSparse ? parts_->factorizeSparse(s) : parts_->factorizeDense(s))) {
        parts_.reset();
        return false;
    }
    parts_->s = s;
    return true;
}

void IterationMatrix::solve(std::span<double> x) const {
    Eigen::Map<Eigen::VectorXd> vector(x.data(), static_cast<Eigen::Index>(x.size()));
    if (parts_->isSparse) {
        vector = Eigen::VectorXd(parts_->sparseFactors.solve(vector));
    } else {
        // Substitution, forwards and back. Most systems here have two or three rows, for which Eigen's own takes memory.
        const DenseMatrix& lu = parts_->denseFactors.matrixLU();
        vector = parts_->denseFactors.permutationP() * vector;
        for (Eigen::Index i = 1; i < lu.rows(); ++i) vector[i] -= lu.row(i).head(i).dot(vector.head(i));
        for (Eigen::Index i = lu.rows() - 1; i >= 0; --i) {
            const Eigen::Index right = lu.rows() - 1 - i;
            vector[i] = (vector[i] - lu.row(i).tail(right).dot(vector.tail(right))) / lu(i, i);
        }
    }
}

void IterationMatrix::rowSizes(std::span<const double> w, std::span<double> result) const {
    const double s = parts_->s.value();
    const auto n = static_cast<std::size_t>(parts_->dimension);
    if (parts_->isSparse) {
        std::ranges::fill(result, 0);
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
