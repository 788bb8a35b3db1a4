#include "mv/motion/eigenvalues.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

struct Square {
    std::vector<double> values;
    std::size_t n;
    double& operator()(std::size_t row, std::size_t column) { return values[row * n + column]; }
    double operator()(std::size_t row, std::size_t column) const { return values[row * n + column]; }
};

double largestOf(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

// Takes out rows of zeros, with their columns, and columns with their rows, one after the other: each is an eigenvalue 0,
// and the others are those of what is left.
Square withoutZeroRows(const Square& matrix) {
    std::vector<std::size_t> left(matrix.n);
    std::iota(left.begin(), left.end(), std::size_t{0});
    const auto isEmpty = [&](std::size_t i) {
        return std::ranges::all_of(left, [&](std::size_t j) { return matrix(i, j) == 0; }) ||
               std::ranges::all_of(left, [&](std::size_t j) { return matrix(j, i) == 0; });
    };
    for (auto found = std::ranges::find_if(left, isEmpty); found != left.end();
         found = std::ranges::find_if(left, isEmpty)) {
        left.erase(found);
    }
    Square result{{}, left.size()};
    for (const std::size_t row : left) {
        for (const std::size_t column : left) result.values.push_back(matrix(row, column));
    }
    return result;
}

// Scales unknowns by powers of two until each row is about as large as its column: positions and velocities differ by
// a factor of the largest frequency, by which errors would be larger. Source: Parlett and Reinsch, Numer. Math. 13 (1969).
void balance(Square& a) {
    for (bool isBalanced = false; !isBalanced;) {
        isBalanced = true;
        for (std::size_t i = 0; i < a.n; ++i) {
            double column = -std::abs(a(i, i)), row = column;
            for (std::size_t j = 0; j < a.n; ++j) {
                column += std::abs(a(j, i));
                row += std::abs(a(i, j));
            }
            if (!(column > 0 && row > 0)) continue;
            const double factor = std::exp2(std::round(std::log2(row / column) / 2));
            if (column * factor + row / factor >= 0.95 * (column + row)) continue;
            isBalanced = false;
            for (std::size_t j = 0; j < a.n; ++j) {
                a(j, i) *= factor;
                a(i, j) /= factor;
            }
        }
    }
}

// Eigen::EigenSolver takes these steps as well, and those for eigenvectors: without them half as much is compiled.
Eigen::MatrixXd schurForm(const Square& square) {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto n = static_cast<Eigen::Index>(square.n);
    const Eigen::HessenbergDecomposition<Eigen::MatrixXd> reduced(Eigen::Map<const Rows>(square.values.data(), n, n));
    const Eigen::MatrixXd hessenberg = reduced.matrixH();
    Eigen::RealSchur<Eigen::MatrixXd> solver(n);
    if (solver.computeFromHessenberg(hessenberg, hessenberg, false).info() != Eigen::Success)
        throw Error("eigenvalues", "must be found within 40 steps for each, one with another");
    return solver.matrixT();
}

// Of a real Schur form: a block of two has a conjugate pair.
std::vector<std::complex<double>> ofDiagonalBlocks(const Eigen::MatrixXd& t) {
    std::vector<std::complex<double>> found;
    for (Eigen::Index i = 0; i < t.rows(); ++i) {
        if (i + 1 == t.rows() || t(i + 1, i) == 0) {
            found.emplace_back(t(i, i));
            continue;
        }
        const double half = (t(i, i) - t(i + 1, i + 1)) / 2, below = t(i + 1, i), above = t(i, i + 1);
        // Relative to the largest, so that no product is too small.
        const double largest = std::max({std::abs(half), std::abs(below), std::abs(above)});
        const double imaginary =
            largest * std::sqrt(std::abs(std::pow(half / largest, 2) + below / largest * (above / largest)));
        found.emplace_back(t(i + 1, i + 1) + half, imaginary);
        found.emplace_back(t(i + 1, i + 1) + half, -imaginary);
        ++i;
    }
    return found;
}

}  // namespace

std::vector<std::complex<double>> eigenvaluesOf(std::vector<double> matrix, std::size_t n) {
    if (matrix.size() != n * n) throw Error("eigenvalues", "must be of a square matrix");
    if (!std::ranges::all_of(matrix, [](double value) { return std::isfinite(value); }))
        throw Error("eigenvalues", "the matrix must be finite");
    Square square = withoutZeroRows({std::move(matrix), n});
    std::vector<std::complex<double>> found(n - square.n);
    if (square.n == 0) return found;
    // Scales by a power of two to about 1, so that no product overflows.
    const int exponent = std::ilogb(largestOf(square.values));
    for (double& value : square.values) value = std::ldexp(value, -exponent);
    balance(square);
    for (const std::complex<double>& value : ofDiagonalBlocks(schurForm(square)))
        found.emplace_back(std::ldexp(value.real(), exponent), std::ldexp(value.imag(), exponent));
    return found;
}

}  // namespace mv
