// Random numbers for tests and benchmarks.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "mv/math/types.h"

namespace mv::test {

// A seeded stream of numbers that is the same on every machine (std's distributions are not). Two of them in one expression, but for
// braces, come in the order that the compiler likes: take each by itself.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) {}

    // Evenly spread over [low, high).
    double number(double low, double high) {
        // Source: Marsaglia, "Xorshift RNGs", J. Stat. Software 8 (2003).
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
    }

    // A positive number whose logarithm is evenly spread over that of [low, high).
    double logarithmic(double low, double high) { return std::exp(number(std::log(low), std::log(high))); }

    // 1 or -1.
    double sign() { return number(-1, 1) < 0 ? -1 : 1; }

    vec3 point(double size) {
        const double x = number(-size, size);
        const double y = number(-size, size);
        return {x, y, number(-size, size)};
    }

    vec3 direction() {
        for (;;) {
            const vec3 v = point(1);
            const double length = glm::length(v);
            if (length > 0.1 && length <= 1) return v / length;
        }
    }

  private:
    std::uint64_t state_;
};

}  // namespace mv::test
