#include "function_nodes.h"

#include <cmath>

#include "mv/motion/nodes.h"

namespace mv {

double FunctionNodes::valueAt(double x) const {
    return function == Function::runge ? 1 / (1 + 25 * x * x) : std::sin(3 * x);
}

double FunctionNodes::slopeAt(double x) const {
    if (function == Function::sine) return 3 * std::cos(3 * x);
    return -50 * x / ((1 + 25 * x * x) * (1 + 25 * x * x));
}

std::vector<double> FunctionNodes::places() const {
    const int n = count;
    if (spread == Spread::chebyshev) return chebyshevNodes(n, -1, 1);
    std::vector<double> places;
    places.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) places.push_back((2.0 * i - (n - 1)) / (n - 1));
    return places;
}

std::vector<Keyframe<double>> FunctionNodes::keys() const {
    std::vector<Keyframe<double>> keys;
    for (const double x : places()) keys.push_back({x, valueAt(x)});
    return keys;
}

std::function<double(double)> FunctionNodes::polynomial() const {
    const auto through = keys();
    if (form == Form::textbook) return [through](double x) { return textbookPolynomial<double>(through, x); };
    if (form == Form::inFloat) return [through](double x) { return textbookPolynomial<float>(through, x); };
    return [curve = Curve<double>::lagrange(through)](double x) { return curve.position(x); };
}

}  // namespace mv
