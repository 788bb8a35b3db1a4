#include "mv/motion/eigenvalues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Square {
    std::vector<double> values;
    std::size_t n;
    double& operator()(std::size_t row, std::size_t column) { return values[row * n + column]; }
    double operator()(std::size_t row, std::size_t column) const { return values[row * n + column]; }
    double* row(std::size_t i) { return values.data() + i * n; }
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

// Reduces to zeros below the first subdiagonal: column by column, a reflection I - v w^T takes what is below to it, and
// is made from both sides.
void makeHessenberg(Square& a) {
    const std::size_t n = a.n;
    std::vector<double> v(n), w(n);
    for (std::size_t k = 0; k + 2 < n; ++k) {
        double largest = 0, square = 0;
        for (std::size_t i = k + 2; i < n; ++i) largest = std::max(largest, std::abs(a(i, k)));
        if (largest == 0) continue;
        largest = std::max(largest, std::abs(a(k + 1, k)));
        for (std::size_t i = k + 1; i < n; ++i) {
            v[i] = a(i, k) / largest;
            square += v[i] * v[i];
        }
        const double length = std::copysign(std::sqrt(square), v[k + 1]);
        v[k + 1] += length;
        const double scale = 1 / (length * v[k + 1]);
        a(k + 1, k) = -length * largest;
        for (std::size_t i = k + 2; i < n; ++i) a(i, k) = 0;
        // From the left: w is what the reflection takes of each column.
        std::fill(w.begin(), w.end(), 0.0);
        for (std::size_t i = k + 1; i < n; ++i) {
            for (std::size_t j = k + 1; j < n; ++j) w[j] += scale * v[i] * a(i, j);
        }
        for (std::size_t i = k + 1; i < n; ++i) {
            for (std::size_t j = k + 1; j < n; ++j) a(i, j) -= v[i] * w[j];
        }
        // From the right.
        for (std::size_t i = 0; i < n; ++i) {
            double* row = a.row(i);
            double sum = 0;
            for (std::size_t j = k + 1; j < n; ++j) sum += row[j] * v[j];
            for (std::size_t j = k + 1; j < n; ++j) row[j] -= scale * sum * v[j];
        }
    }
}

// The two of a matrix of two rows.
std::pair<std::complex<double>, std::complex<double>> ofTwo(double a, double b, double c, double d) {
    const double half = (a - d) / 2, largest = std::max({std::abs(half), std::abs(b), std::abs(c)});
    if (largest == 0) return {a, d};
    // sqrt(half^2 + b c), which must not overflow.
    const double discriminant = half / largest * (half / largest) + b / largest * (c / largest);
    const double root = largest * std::sqrt(std::abs(discriminant));
    if (discriminant < 0) return {{d + half, root}, {d + half, -root}};
    // The root farther from d; the other by the product of both, which loses no digits.
    const double far = half + std::copysign(root, half);
    return far == 0 ? std::pair{a, d} : std::pair{d + far, d - b / far * c};
}

// A sum and a product of two shifts, by the numbers of a matrix of two rows that has them: its diagonal, and the product of
// the two others.
struct Shifts {
    double first, second, product;
};

// One of Francis' steps with these shifts on the rows and columns from `low` to `high`: a bulge below the subdiagonal is
// made where the first reflection begins, and chased out.
void francisStep(Square& h, std::size_t low, std::size_t high, const Shifts& shifts) {
    // The first column of (H - s1)(H - s2), over an element of the subdiagonal; from where two of those before it are so
    // small that nothing above is felt.
    double p = 0, q = 0, r = 0;
    std::size_t start = high - 2;
    for (;; --start) {
        const double here = h(start, start), below = h(start + 1, start);
        const double one = shifts.first - here, other = shifts.second - here;
        p = (one * other - shifts.product) / below + h(start, start + 1);
        q = h(start + 1, start + 1) - here - one - other;
        r = h(start + 2, start + 1);
        const double size = std::abs(p) + std::abs(q) + std::abs(r);
        p /= size;
        q /= size;
        r /= size;
        if (start == low) break;
        const double around = std::abs(h(start - 1, start - 1)) + std::abs(here) + std::abs(h(start + 1, start + 1));
        if (std::abs(h(start, start - 1)) * (std::abs(q) + std::abs(r)) <= epsilon * std::abs(p) * around) break;
    }
    for (std::size_t k = start; k < high; ++k) {
        const bool three = k + 2 <= high;
        double size = 1;
        if (k > start) {
            p = h(k, k - 1);
            q = h(k + 1, k - 1);
            r = three ? h(k + 2, k - 1) : 0;
            size = std::abs(p) + std::abs(q) + std::abs(r);
            if (size == 0) continue;
            p /= size;
            q /= size;
            r /= size;
        }
        const double length = std::copysign(std::sqrt(p * p + q * q + r * r), p);
        if (k > start) {
            h(k, k - 1) = -length * size;
            h(k + 1, k - 1) = 0;
            if (three) h(k + 2, k - 1) = 0;
        } else if (start > low) {
            h(k, k - 1) = -h(k, k - 1);
        }
        // I - (x, y, z)^T (1, q, r) / p
        p += length;
        const double x = p / length, y = q / length, z = r / length;
        q /= p;
        r /= p;
        for (std::size_t j = k; j <= high; ++j) {
            const double sum = h(k, j) + q * h(k + 1, j) + (three ? r * h(k + 2, j) : 0);
            h(k, j) -= sum * x;
            h(k + 1, j) -= sum * y;
            if (three) h(k + 2, j) -= sum * z;
        }
        for (std::size_t i = low; i <= std::min(high, k + 3); ++i) {
            const double sum = x * h(i, k) + y * h(i, k + 1) + (three ? z * h(i, k + 2) : 0);
            h(i, k) -= sum;
            h(i, k + 1) -= sum * q;
            if (three) h(i, k + 2) -= sum * r;
        }
    }
}

// The eigenvalues are found from below: each step makes the last elements of the subdiagonal smaller, and where one is as
// small as rounding, what is below stands alone.
void addEigenvalues(Square& h, std::vector<std::complex<double>>& found) {
    // Some take more and others less: of a cluster of zeros the first can take a hundred.
    constexpr std::size_t mostSteps = 40;
    const double largest = largestOf(h.values);
    std::size_t steps = 0, all = 0;
    for (std::size_t end = h.n; end > 0;) {
        const std::size_t high = end - 1;
        std::size_t low = high;
        for (; low > 0; --low) {
            const double beside = std::abs(h(low - 1, low - 1)) + std::abs(h(low, low));
            if (std::abs(h(low, low - 1)) <= epsilon * (beside == 0 ? largest : beside)) break;
        }
        if (low == high) {
            found.emplace_back(h(high, high));
            end -= 1;
            steps = 0;
        } else if (low + 1 == high) {
            const auto [one, other] = ofTwo(h(low, low), h(low, high), h(high, low), h(high, high));
            found.insert(found.end(), {one, other});
            end -= 2;
            steps = 0;
        } else {
            ++steps;
            if (++all > mostSteps * h.n)
                throw Error("eigenvalues", "must be found within 40 steps for each, one with another");
            Shifts shifts{h(high, high), h(high - 1, high - 1), h(high, high - 1) * h(high - 1, high)};
            if (steps % 10 == 0) {  // a permutation, say, comes back to itself by its own shifts
                const double size = std::abs(h(high, high - 1)) + std::abs(h(high - 1, high - 2));
                const double mean = 0.75 * size + h(high, high);
                shifts = {mean, mean, -0.4375 * size * size};
            }
            francisStep(h, low, high, shifts);
        }
    }
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
    makeHessenberg(square);
    addEigenvalues(square, found);
    for (auto& value : found) value = {std::ldexp(value.real(), exponent), std::ldexp(value.imag(), exponent)};
    return found;
}

}  // namespace mv
