#include "mv/motion/nodes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/types.h"

namespace mv {

std::vector<double> chebyshevNodes(int count, double low, double high) {
    requireRange("chebyshevNodes", "count", count, 2, 1000);
    requireFinite("chebyshevNodes", "low", low);
    requireFinite("chebyshevNodes", "high", high);
    if (!(low < high))
        throw Error("chebyshevNodes", "low must be below high", numberText(low) + ", " + numberText(high));
    std::vector<double> nodes;
    for (int i = 0; i < count; ++i) {
        // The cosine as a sine, which is 0 in the middle and the same on both sides. Halved: the range may be infinite.
        const double part = std::sin(pi / 2 * (2 * i - (count - 1)) / (count - 1));
        nodes.push_back(low / 2 + high / 2 + part * (high / 2 - low / 2));
    }
    nodes.front() = low;
    nodes.back() = high;
    if (std::ranges::adjacent_find(nodes, std::greater_equal()) != nodes.end()) {
        throw Error("chebyshevNodes", "low and high must be so far apart that the nodes differ",
                    numberText(low) + ", " + numberText(high));
    }
    return nodes;
}

double lebesgueConstant(std::span<const double> times) {
    if (times.empty()) throw Error("lebesgueConstant", "there must be one time at least", "0");
    for (std::size_t i = 0; i < times.size(); ++i) {
        requireFinite("lebesgueConstant", "a time", times[i]);
        if (i > 0 && !(times[i - 1] < times[i])) {
            throw Error("lebesgueConstant", "times must increase",
                        numberText(times[i]) + " after " + numberText(times[i - 1]));
        }
    }
    double largest = 1;
    for (std::size_t gap = 0; gap + 1 < times.size(); ++gap) {
        const double between = times[gap] / 2 + times[gap + 1] / 2;
        double sum = 0;
        for (std::size_t j = 0; j < times.size(); ++j) {
            double basis = 1;
            for (std::size_t k = 0; k < times.size(); ++k) {
                if (k != j) basis *= (between - times[k]) / (times[j] - times[k]);
            }
            sum += std::abs(basis);
        }
        largest = std::max(largest, sum);
    }
    return largest;
}

std::optional<std::string> swingWarning(std::span<const double> times) {
    const double constant = lebesgueConstant(times);
    if (constant <= 50) return std::nullopt;
    char factor[32];
    std::snprintf(factor, sizeof factor, "%.2g", constant);
    return "one polynomial through " + std::to_string(times.size()) +
           " keys at these times swings between them: a key that is off by 1 moves it by " + factor +
           " or more; a spline does not, nor the times of chebyshevNodes";
}

}  // namespace mv
