// Helpers that the maths tests share: differences of matrices, and the text of a refusal.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>

#include "mv/error.h"
#include "mv/math/types.h"
#include "support/random.h"

namespace mv::test {

// The largest absolute difference of two elements; infinity when one is NaN, so that a NaN never passes a bound.
template <int C, int R, typename T, glm::qualifier Q>
double largestDifference(const glm::mat<C, R, T, Q>& a, const glm::mat<C, R, T, Q>& b) {
    double largest = 0;
    for (int column = 0; column < C; ++column) {
        for (int row = 0; row < R; ++row) {
            const double difference =
                std::abs(static_cast<double>(a[column][row]) - static_cast<double>(b[column][row]));
            if (std::isnan(difference)) return HUGE_VAL;
            largest = std::max(largest, difference);
        }
    }
    return largest;
}

// The largest element of R^T R - I for the rotation part of a matrix: 0 when its columns are orthogonal and of unit
// length.
template <typename T, glm::qualifier Q>
double orthogonalityError(const glm::mat<4, 4, T, Q>& m) {
    const mat3 rotation = mat3(glm::mat<3, 3, T, Q>(m));
    return largestDifference(glm::transpose(rotation) * rotation, mat3(1));
}

// The text of the mv::Error that the call throws, or a sentence that no test expects.
inline std::string refusal(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was refused";
}

inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();
// A few roundings of numbers of size 1 (1.1e-16 each).
inline constexpr double rounding = 2e-15;
inline const vec4 ground(0, 1, 0, 0);  // y = 0

}  // namespace mv::test
