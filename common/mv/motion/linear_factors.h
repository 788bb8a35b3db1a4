// Elimination with row exchanges, of real and complex matrices, dense ones and bands: what IterationMatrix solves by.
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace mv {

// Products without the question whether they overflowed, which std::complex asks and which costs more than they do.
inline double product(double a, double b) { return a * b; }
inline std::complex<double> product(const std::complex<double>& a, const std::complex<double>& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
// As large as the number to a factor of 2, for the choice of a pivot.
inline double roughSize(double a) { return std::abs(a); }
inline double roughSize(const std::complex<double>& a) { return std::abs(a.real()) + std::abs(a.imag()); }

// An n x n matrix of which row i has entries from column i - lower to i + upper; dense where both are n - 1.
template <typename T>
class LinearFactors {
  public:
    // All entries 0. Keeps its memory.
    void reset(std::size_t n, std::size_t lower, std::size_t upper) {
        n_ = n, lower_ = lower;
        upper_ = std::min(n - 1, upper + lower);  // exchanges of rows fill it
        isDense_ = lower_ + 1 == n && upper_ + 1 == n;
        width_ = isDense_ ? n : lower_ + upper_ + 1;
        entries_.assign(n * width_, T(0));
        pivots_.resize(n);
        inverses_.resize(n);
    }
    T& at(std::size_t row, std::size_t column) { return entries_[place(row, column)]; }

    // False where a pivot is 0 or not finite: the matrix is singular, or overflowed.
    bool factorize() {
        for (std::size_t k = 0; k < n_; ++k) {
            const std::size_t bottom = std::min(n_, k + lower_ + 1), right = std::min(n_, k + upper_ + 1);
            std::size_t pivot = k;
            double largest = roughSize(entries_[place(k, k)]);
            for (std::size_t i = k + 1; i < bottom; ++i) {
                const double size = roughSize(entries_[place(i, k)]);
                if (size > largest) largest = size, pivot = i;
            }
            if (!(largest > 0) || !std::isfinite(largest)) return false;
            pivots_[k] = pivot;
            T* const top = &entries_[place(k, k)];
            const std::size_t count = right - k;
            if (pivot != k) std::swap_ranges(top, top + count, &entries_[place(pivot, k)]);
            inverses_[k] = T(1) / *top;
            for (std::size_t i = k + 1; i < bottom; ++i) {
                T* const row = &entries_[place(i, k)];
                if (*row == T(0)) continue;
                const T factor = *row = product(*row, inverses_[k]);
                for (std::size_t j = 1; j < count; ++j) row[j] -= product(factor, top[j]);
            }
        }
        return true;
    }

    void solve(std::span<T> x) const {
        for (std::size_t k = 0; k < n_; ++k) {
            std::swap(x[k], x[pivots_[k]]);
            const T known = x[k];
            const std::size_t bottom = std::min(n_, k + lower_ + 1);
            for (std::size_t i = k + 1; i < bottom; ++i) x[i] -= product(entries_[place(i, k)], known);
        }
        for (std::size_t k = n_; k-- > 0;) {
            const std::size_t right = std::min(n_, k + upper_ + 1);
            const T* const row = &entries_[place(k, k)];
            T sum = x[k];
            for (std::size_t j = 1; j < right - k; ++j) sum -= product(row[j], x[k + j]);
            x[k] = product(sum, inverses_[k]);
        }
    }

  private:
    std::size_t place(std::size_t row, std::size_t column) const {
        return isDense_ ? row * n_ + column : row * width_ + column + lower_ - row;
    }
    std::size_t n_ = 0, lower_ = 0, upper_ = 0, width_ = 0;
    bool isDense_ = false;
    std::vector<T> entries_, inverses_;
    std::vector<std::size_t> pivots_;
};

}  // namespace mv
