#include "lamp_light.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

void requireNotBelowZero(const char* subject, const char* name, double value) {
    if (!(value >= 0 && isFinite(value))) {
        throw Error(subject, std::string(name) + " must be 0 or above, and finite", numberText(value));
    }
}

}  // namespace

double Falloff::at(double distance) const {
    requireNotBelowZero("Falloff", "distance", distance);
    requireNotBelowZero("Falloff", "constant", constant);
    requireNotBelowZero("Falloff", "linear", linear);
    requireNotBelowZero("Falloff", "quadratic", quadratic);
    requireNotBelowZero("Falloff", "size", size);
    const double d = std::max(distance, size);
    const double sum = constant + d * (linear + d * quadratic);
    if (sum == 0) throw Error("Falloff", "must not divide by 0: a constant, or a distance or size above 0");
    return 1 / sum;
}

double Falloff::reach(double power, double threshold) const {
    if (threshold <= 0) return HUGE_VAL;
    // Solve constant - power / threshold + linear d + quadratic d^2 = 0 in the form without a difference of near numbers
    const double missing = power / threshold - constant;
    if (missing <= 0) return 0;
    if (linear == 0 && quadratic == 0) return HUGE_VAL;
    return 2 * missing / (linear + std::sqrt(linear * linear + 4 * quadratic * missing));
}

double spotEdge(double cosine, double innerCosine, double outerCosine) {
    if (!(innerCosine >= outerCosine && isFinite(cosine))) {
        throw Error("spotEdge", "must have the inner cone within the outer one, and cosines that are numbers");
    }
    if (cosine >= innerCosine) return 1;
    if (cosine <= outerCosine) return 0;
    const double t = (cosine - outerCosine) / (innerCosine - outerCosine);
    return t * t * (3 - 2 * t);
}

}  // namespace mv
