// The mean of a board's squares over the width of a ray's cone.
#include <cmath>

#include "whitted.h"

namespace mv {

double squaresAround(double x, double z, double square, double width) {
    // The board is the product of two functions, along x and along z, that are -1 and 1 in turn. The mean of one over a width is
    // the difference of its integral, a triangle wave, at both ends
    const auto mean = [&](double at) {
        const auto integral = [](double u) {
            return std::abs(u - 2 * std::floor(u / 2) - 1);
        };  // of sign, up to the sign
        const double u = at / square, half = width / square / 2;
        if (half < 1e-9) return static_cast<long long>(std::floor(u)) % 2 == 0 ? 1.0 : -1.0;
        return (integral(u - half) - integral(u + half)) / (2 * half);
    };
    return 0.5 + 0.5 * mean(x) * mean(z);
}

}  // namespace mv
