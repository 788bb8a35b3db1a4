// Whatever the structure, what comes out solves the system.
#include "mv/motion/iteration_matrix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

using Complex = std::complex<double>;

// J has `diagonals` random diagonals on each side, its rows and columns in an order that hides them; `isSparse` says how
// it is given.
OdeProblem banded(std::size_t n, std::size_t diagonals, bool isSparse, std::vector<double>& dense) {
    Random random(static_cast<std::uint64_t>(n));
    std::vector<MatrixEntry> entries;
    const auto hidden = [n](std::size_t i) { return (i * 7 + 3) % n; };  // n has no factor 7
    dense.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i < diagonals ? 0 : i - diagonals; j < std::min(n, i + diagonals + 1); ++j) {
            const double value = random.number(-1, 1);
            dense[hidden(i) * n + hidden(j)] = value;
            entries.push_back({static_cast<int>(hidden(i)), static_cast<int>(hidden(j)), value});
        }
    }
    OdeProblem problem{.dimension = n, .slope = [](double, std::span<const double>, std::span<double>) {}};
    if (isSparse) {
        problem.sparseJacobian = [entries](double, std::span<const double>, std::vector<MatrixEntry>& result) {
            result = entries;
        };
    } else {
        problem.jacobian = [dense](double, std::span<const double>, std::span<double> result) {
            std::ranges::copy(dense, result.begin());
        };
    }
    return problem;
}

// |(s I - J) x - b| / |b|, largest entries.
template <typename T>
double residual(const std::vector<double>& jacobian, T s, const std::vector<T>& x, const std::vector<T>& b) {
    double worst = 0, size = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        T sum = s * x[i] - b[i];
        for (std::size_t j = 0; j < b.size(); ++j) sum -= jacobian[i * b.size() + j] * x[j];
        worst = std::max(worst, std::abs(sum));
        size = std::max(size, std::abs(b[i]));
    }
    return worst / size;
}

TEST(IterationMatrix, SolvesInEveryStructure) {
    struct Case {
        std::size_t n, diagonals;
        bool isSparse;
    };
    // Dense ones, bands of one to 40 diagonals, and a sparse one that is full.
    for (const auto& [n, diagonals, isSparse] : {Case{1, 0, false},
                                                 {3, 2, false},
                                                 {32, 31, false},
                                                 {33, 32, false},
                                                 {1, 0, true},
                                                 {100, 1, true},
                                                 {100, 24, true},
                                                 {100, 40, true},
                                                 {100, 99, true}}) {
        SCOPED_TRACE(std::to_string(n) + " rows, " + std::to_string(diagonals) + " diagonals, sparse " +
                     std::to_string(isSparse));
        std::vector<double> jacobian;
        const OdeProblem problem = banded(n, diagonals, isSparse, jacobian);
        const std::vector<double> y(n, 1.0), slope(n);
        OdeCounts counts;
        IterationMatrix matrix;
        ASSERT_TRUE(matrix.evaluate(problem, 0, y, slope, 1, counts));
        const double s = 3;
        const Complex z(3, 2);
        ASSERT_TRUE(matrix.factorize(s, counts));
        ASSERT_TRUE(matrix.factorize(z, counts));
        ASSERT_TRUE(matrix.factorize(s, counts));  // it is so already
        EXPECT_EQ(counts.factorizations, 2);
        const IterationMatrix copy = matrix;
        Random random(1);
        std::vector<double> b(n);
        std::vector<Complex> c(n);
        for (std::size_t i = 0; i < n; ++i) b[i] = random.number(-1, 1), c[i] = {b[i], random.number(-1, 1)};
        std::vector<double> x = b, again = b;
        std::vector<Complex> w = c;
        matrix.solve(x);
        matrix.solve(w);
        copy.solve(again);
        EXPECT_EQ(x, again);
        // 100 rows of random numbers, of which some are nearly dependent.
        EXPECT_LT(residual(jacobian, s, x, b), 1e-12);
        EXPECT_LT(residual(jacobian, z, w, c), 1e-12);
    }
}

TEST(IterationMatrix, ACopyKeepsWhatItSharesWhenItMakesMore) {
    std::vector<double> jacobian;
    const OdeProblem problem = banded(20, 2, true, jacobian);
    const std::vector<double> y(20, 1.0), slope(20);
    OdeCounts counts;
    IterationMatrix matrix;
    ASSERT_TRUE(matrix.evaluate(problem, 0, y, slope, 1, counts));
    ASSERT_TRUE(matrix.factorize(3, counts));
    IterationMatrix copy = matrix;
    ASSERT_TRUE(copy.factorize(Complex(3, 2), counts));
    std::vector<double> x(20, 1.0), again = x;
    matrix.solve(x);
    copy.solve(again);
    EXPECT_EQ(x, again);
}

TEST(IterationMatrix, SaysWhatIsSingular) {
    for (const bool isSparse : {false, true}) {
        std::vector<double> jacobian;
        OdeProblem problem = banded(4, 0, isSparse, jacobian);
        OdeCounts counts;
        IterationMatrix matrix;
        const std::vector<double> y(4, 1.0), slope(4);
        ASSERT_TRUE(matrix.evaluate(problem, 0, y, slope, 1, counts));
        EXPECT_FALSE(matrix.factorize(jacobian[0], counts));
        EXPECT_FALSE(matrix.exists());
    }
}

}  // namespace
