// The measures that several rows share.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "mv/error.h"
#include "mv/math/types.h"
#include "support/wide.h"

namespace mv::test {

inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

// The worst is infinity where anything is NaN: std::max would pass over a NaN.
inline double worse(double worst, double error) { return std::isnan(error) ? infinite : std::max(worst, error); }

// The largest element of R^T R - I for the rotation part of a matrix, computed wide; infinity where one is NaN.
template <typename T, glm::qualifier Q>
double orthogonality(const glm::mat<4, 4, T, Q>& m) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const Wide product = dot(wide(glm::vec<3, T, Q>(m[i])), wide(glm::vec<3, T, Q>(m[k])));
            worst = worse(worst, static_cast<double>(abs(product - (i == k ? 1 : 0))));
        }
    }
    return worst;
}

template <typename Matrix>
bool allFinite(const Matrix& m) {
    for (int column = 0; column < Matrix::length(); ++column) {
        for (int row = 0; row < Matrix::col_type::length(); ++row) {
            if (!std::isfinite(m[column][row])) return false;
        }
    }
    return true;
}

// 0 where the call ends in an mv::Error, as it should; 1 where it returns.
inline double accepted(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error&) {
        return 0;
    }
    return 1;
}

inline double distance(const Wide3& a, const Wide3& b) { return static_cast<double>(length(a - b)); }

}  // namespace mv::test
