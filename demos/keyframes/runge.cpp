// One polynomial through many nodes of a function, and the chosen curve through the same nodes.
#include <algorithm>
#include <cmath>

#include "keyframes.h"
#include "mv/motion/nodes.h"

namespace mv::keyframes {
namespace {

template <class Value>
std::vector<double> sampled(const Value& value) {
    std::vector<double> values(samples);
    for (std::size_t i = 0; i < samples; ++i) values[i] = value(sampleAt(i));
    return values;
}
double error(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < samples; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

}  // namespace

void drawRunge(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Recompute the values when the function or the curve has changed
    if (gpu.sampledFor.changed(s.curve, s.nodes)) {
        gpu.sampled = {.right = sampled([&](double x) { return s.nodes.valueAt(x); }),
                       .polynomial = polynomialValues(s),
                       .curve = curveValues(s),
                       .warning = swingWarning(s.nodes.places())};
    }

    // Draw the values and their errors, and warn of a polynomial that is bound to swing
    showValues(gpu.drawing, s, gpu.sampled, frame.inUnits());
    if (gpu.sampled.warning) frame.say(*gpu.sampled.warning);
}

double sampleAt(std::size_t i) { return (2 * double(i) + 1) / samples - 1; }

std::vector<double> polynomialValues(const Settings& s) { return sampled(s.nodes.polynomial()); }
std::vector<double> curveValues(const Settings& s) {
    const Motion<double> motion = s.curve.through(s.nodes.keys(), s.nodes.slopeAt(-1), s.nodes.slopeAt(1));
    return sampled([&](double x) { return motion.position(x); });
}

double Sampled::polynomialError() const { return error(polynomial, right); }
double Sampled::curveError() const { return error(curve, right); }

}  // namespace mv::keyframes
