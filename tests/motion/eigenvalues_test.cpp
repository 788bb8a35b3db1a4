#include "mv/motion/eigenvalues.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/support.h"
#include "mv/error.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

using Complex = std::complex<double>;
using Eigenvalues = std::vector<Complex>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Matrix {
    std::size_t n;
    std::vector<double> values = std::vector<double>(n * n);
    double& operator()(std::size_t row, std::size_t column) { return values[row * n + column]; }
    Eigenvalues found() const { return eigenvaluesOf(values, n); }
};

// The farthest that a value of one list is from its own in the other: each is taken once.
double distance(const Eigenvalues& one, Eigenvalues other) {
    EXPECT_EQ(one.size(), other.size());
    double most = 0;
    for (const Complex& value : one) {
        const auto nearest =
            std::ranges::min_element(other, {}, [&](const Complex& each) { return std::abs(each - value); });
        if (nearest == other.end()) break;
        most = std::max(most, std::abs(*nearest - value));
        other.erase(nearest);
    }
    return most;
}

// Blocks with these eigenvalues on a diagonal, each complex one with its conjugate, turned by reflections from both sides.
Matrix turned(const Eigenvalues& values, Random& random) {
    Matrix matrix{values.size()};
    for (std::size_t i = 0; i < matrix.n; ++i) {
        matrix(i, i) = values[i].real();
        if (values[i].imag() == 0) continue;
        matrix(i + 1, i + 1) = values[i].real();
        matrix(i, i + 1) = values[i].imag();
        matrix(i + 1, i) = -values[i].imag();
        ++i;
    }
    for (std::size_t times = 0; times < matrix.n; ++times) {
        std::vector<double> v(matrix.n);
        double square = 0;
        for (double& each : v) {
            each = random.number(-1, 1);
            square += each * each;
        }
        for (const bool fromLeft : {true, false}) {
            for (std::size_t j = 0; j < matrix.n; ++j) {
                const auto at = [&](std::size_t i) -> double& { return fromLeft ? matrix(i, j) : matrix(j, i); };
                double along = 0;
                for (std::size_t i = 0; i < matrix.n; ++i) along += v[i] * at(i);
                for (std::size_t i = 0; i < matrix.n; ++i) at(i) -= 2 * along / square * v[i];
            }
        }
    }
    return matrix;
}

Eigenvalues somePairsAndReals(std::size_t n, Random& random) {
    Eigenvalues values;
    while (values.size() < n) {
        const double real = random.number(-1, 1), imaginary = random.number(0.01, 1);
        if (values.size() + 1 < n && random.number(0, 1) < 0.5) {
            values.emplace_back(real, imaginary);
            values.emplace_back(real, -imaginary);
        } else {
            values.emplace_back(real);
        }
    }
    return values;
}

}  // namespace

// A matrix that reflections turn stays normal, whose eigenvalues move by no more than its elements do: by some roundings of the
// largest for each of the n reflections here, of the n - 2 in it, and of the few steps for each value.
TEST(Eigenvalues, AreThoseThatTheMatrixWasMadeOf) {
    Random random(11);
    for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 8U, 13U, 40U, 120U}) {
        for (int times = 0; times < (n < 20 ? 200 : 3); ++times) {
            const Eigenvalues values = somePairsAndReals(n, random);
            double largest = 0;
            for (const Complex& each : values) largest = std::max(largest, std::abs(each));
            EXPECT_LE(distance(values, turned(values, random).found()), 10 * double(n) * epsilon * largest) << n;
        }
    }
}

// A step by its own shifts leaves a cycle as it is: only the exceptional ones end it.
TEST(Eigenvalues, OfACycleAreTheRootsOfOne) {
    for (const std::size_t n : {3U, 4U, 5U, 12U}) {
        Matrix cycle{n};
        Eigenvalues roots;
        for (std::size_t i = 0; i < n; ++i) {
            cycle(i, (i + 1) % n) = 1;
            roots.push_back(std::polar(1.0, 2 * pi * double(i) / double(n)));
        }
        EXPECT_LE(distance(roots, cycle.found()), 10 * double(n) * epsilon) << n;
    }
}

// Balancing takes back what powers of two do to unknowns: a matrix scaled so has its own eigenvalues, not with errors as large
// as its largest element, 2^60 here.
TEST(Eigenvalues, DoNotFeelTheUnitsOfTheUnknowns) {
    Random random(3);
    for (int times = 0; times < 50; ++times) {
        const Eigenvalues values = somePairsAndReals(6, random);
        Matrix matrix = turned(values, random);
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < 6; ++j)
                matrix(i, j) = std::ldexp(matrix(i, j), 12 * (static_cast<int>(i) - static_cast<int>(j)));
        }
        // Balanced within a factor of two for each, which the bound of the others allows for.
        EXPECT_LE(distance(values, matrix.found()), 2 * 60 * epsilon);
    }
}

// Masses of which nothing holds half: each of their zeros is a double one with one direction, as of a mass that moves freely, and
// all of these are one cluster, whose first value takes more than 40 steps.
TEST(Eigenvalues, OfManyFreeMassesAreZeros) {
    constexpr std::size_t masses = 70, held = 40;
    Random random(9);
    Eigenvalues squares(masses), expected(2 * (masses - held));
    for (std::size_t i = 0; i < held; ++i) {
        squares[i] = random.number(0.1, 1);
        expected.emplace_back(0, std::sqrt(squares[i].real()));
        expected.emplace_back(0, -std::sqrt(squares[i].real()));
    }
    Matrix stiffness = turned(squares, random), whole{2 * masses};
    for (std::size_t i = 0; i < masses; ++i) {
        whole(i, masses + i) = 1;
        for (std::size_t j = 0; j < masses; ++j) whole(masses + i, j) = -stiffness(i, j);
    }
    // Half of the digits, and of as many roundings as unknowns.
    EXPECT_LE(distance(expected, whole.found()), std::sqrt(double(whole.n) * epsilon));
}

TEST(Eigenvalues, OfNilpotentAndTriangularMatricesAreExact) {
    // Powers of it vanish: all zeros, where the cube root of a rounding would be 6e-6.
    EXPECT_EQ(eigenvaluesOf({0, 0, 0, -0.6018, 0, 0, 1.8847, -1.4757, 0}, 3), Eigenvalues(3));
    EXPECT_EQ(eigenvaluesOf({0, 0, 0, 0}, 2), Eigenvalues(2));
    EXPECT_EQ(eigenvaluesOf({}, 0), Eigenvalues());
    EXPECT_EQ(distance({3, -1, 0.5}, eigenvaluesOf({3, 7, -2, 0, -1, 9, 0, 0, 0.5}, 3)), 0);
}

// Products of such elements are beyond all doubles. A power of two changes no digit.
TEST(Eigenvalues, OfVeryLargeAndVerySmallElements) {
    Random random(5);
    for (const int exponent : {-900, 1020}) {
        const Matrix matrix = turned(somePairsAndReals(6, random), random);
        std::vector<double> scaled = matrix.values;
        for (double& each : scaled) each = std::ldexp(each, exponent);
        Eigenvalues found = eigenvaluesOf(scaled, 6);
        for (Complex& each : found) each = {std::ldexp(each.real(), -exponent), std::ldexp(each.imag(), -exponent)};
        EXPECT_EQ(found, matrix.found());
    }
    // Elements that have lost digits have an eigenvalue that has.
    EXPECT_EQ(distance({{4e-320, 4e-320}, {4e-320, -4e-320}}, eigenvaluesOf({4e-320, 4e-320, -4e-320, 4e-320}, 2)), 0);
}

TEST(Eigenvalues, AreRefusedWhereThereAreNone) {
    EXPECT_THROW(eigenvaluesOf({1, 2, 3}, 2), Error);
    EXPECT_THROW(eigenvaluesOf({1, 2, 3, infinite}, 2), Error);
    EXPECT_THROW(eigenvaluesOf({1, 2, 3, std::nan("")}, 2), Error);
}
