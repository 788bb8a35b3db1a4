// Sums of doubles of which nothing is rounded off: for signs that rounding would turn over.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace mv {

// The sum of at most `most` numbers, a product counting for two, as a list of numbers that overlap in no bit, the least first.
// All must be finite, the sum must not overflow, and a product must be 0 or at least 1e-290, so that its rounding is a number, too.
// Trap: none of that is checked.
// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997), grow-expansion.
template <std::size_t most>
class ExactSum {
  public:
    void add(double x) {
        for (std::size_t i = 0; i < count_; ++i) {  // Knuth's sum, whose rounding stays behind
            const double sum = x + parts_[i], added = sum - x;
            parts_[i] = (x - (sum - added)) + (parts_[i] - added);
            x = sum;
        }
        parts_[count_++] = x;
    }
    void addProduct(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }
    // -1, 0 or 1: that of the last part that is not 0, for all before it are smaller than its last bit.
    int sign() const {
        for (std::size_t i = count_; i-- > 0;) {
            if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
        }
        return 0;
    }

  private:
    std::array<double, most> parts_{};
    std::size_t count_ = 0;
};

}  // namespace mv
