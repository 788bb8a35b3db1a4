#include "mv/motion/gauss.h"

#include <cmath>
#include <cstddef>

#include "mv/math/require.h"
#include "mv/math/types.h"

namespace mv {
namespace {

struct Legendre {
    double value, slope;
};

// The Legendre polynomial of degree n, by its recurrence, within -1 < x < 1.
Legendre legendre(int n, double x) {
    double before = 0, value = 1;
    for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, n * (before - x * value) / ((1 - x) * (1 + x))};
}

}  // namespace

GaussRule gaussLegendre(int count) {
    requireRange("gaussLegendre", "count", count, 1, 64);
    const auto size = static_cast<std::size_t>(count);
    GaussRule rule{std::vector<double>(size), std::vector<double>(size)};
    for (std::size_t i = 0; i < (size + 1) / 2; ++i) {
        // The i-th zero from the right; the middle one of an odd count is 0.
        const double n = count, index = static_cast<double>(i);
        double x = 2 * i + 1 == size ? 0 : (1 - (n - 1) / (8 * n * n * n)) * std::cos(pi * (index + 0.75) / (n + 0.5));
        // The estimate has two digits at least, and each step doubles them.
        for (int step = 0; step < 5 && x != 0; ++step) {
            const Legendre p = legendre(count, x);
            x -= p.value / p.slope;
        }
        const double slope = legendre(count, x).slope;
        const double weight = 2 / ((1 - x) * (1 + x) * slope * slope);
        rule.nodes[i] = -x;
        rule.nodes[size - 1 - i] = x;
        rule.weights[i] = rule.weights[size - 1 - i] = weight;
    }
    return rule;
}

}  // namespace mv
