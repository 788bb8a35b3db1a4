#include "mv/geometry/plot.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

double placed(const Axis& axis, double value) {
    if (!axis.logarithmic) return value;
    if (!(value > 0)) throw Error("plot", "a value on a logarithmic axis must be above 0", numberText(value));
    return std::log(value);
}

// The part of the way from the low end to the high one, and back.
double partOf(const Axis& axis, double value) {
    const double low = placed(axis, axis.low), high = placed(axis, axis.high);
    if (low == high) throw Error("plot", "the ends of an axis must differ", numberText(axis.low));
    return (placed(axis, value) - low) / (high - low);
}
double valueAt(const Axis& axis, double part) {
    const double low = placed(axis, axis.low), high = placed(axis, axis.high), value = low + part * (high - low);
    return axis.logarithmic ? std::exp(value) : value;
}

// 10^exponent times whole, rounded once: a negative power divides.
double timesPowerOfTen(double whole, int exponent) {
    return exponent >= 0 ? whole * std::pow(10.0, exponent) : whole / std::pow(10.0, -exponent);
}

std::vector<double> decades(const Axis& axis, int most) {
    const int first = int(std::ceil(std::log10(axis.low) - 1e-9)), last = int(std::floor(std::log10(axis.high) + 1e-9));
    const int step = std::max(1, (last - first + most) / most);
    std::vector<double> values;
    for (int exponent = first; exponent <= last; exponent += step) values.push_back(timesPowerOfTen(1, exponent));
    return values;
}

}  // namespace

vec2 Plot::pixel(const vec2& value) const {
    return box.low + vec2(partOf(x, value.x), partOf(y, value.y)) * box.size();
}

vec2 Plot::value(const vec2& pixel) const {
    const vec2 part = (pixel - box.low) / box.size();
    return {valueAt(x, part.x), valueAt(y, part.y)};
}

std::vector<double> ticks(const Axis& axis, int most) {
    requireFinite("ticks", "the ends", vec3(axis.low, axis.high, 0));
    if (!(axis.low < axis.high)) throw Error("ticks", "the low end must be below the high one", numberText(axis.low));
    if (most < 1) throw Error("ticks", "there must be room for 1 or more", std::to_string(most));
    if (axis.logarithmic) {
        if (!(axis.low > 0)) throw Error("ticks", "a logarithmic axis must begin above 0", numberText(axis.low));
        return decades(axis, most);
    }
    // From steps far too small upwards, until there are few enough; an end that is a multiple but for its rounding is one
    for (int exponent = int(std::floor(std::log10((axis.high - axis.low) / most))) - 1;; ++exponent) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = timesPowerOfTen(digit, exponent);
            const double first = std::ceil(axis.low / step - 1e-9), last = std::floor(axis.high / step + 1e-9);
            if (last - first + 1 > most) continue;
            std::vector<double> values;
            for (int i = 0; first + i <= last; ++i)
                values.push_back(timesPowerOfTen((first + i) * digit, exponent) + 0.0);
            return values;
        }
    }
}

std::string tickText(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value + 0.0);  // and -0 is 0
    std::string words = text.data();
    // printf writes two digits of the exponent at least, and its sign
    if (const auto e = words.find('e'); e != std::string::npos) {
        const int exponent = std::stoi(words.substr(e + 1));
        words = words.substr(0, e + 1) + std::to_string(exponent);
    }
    return words;
}

}  // namespace mv
