#include "mv/geometry/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/portable_number.h"

namespace mv {
namespace {

double placed(const Axis& axis, double value) {
    if (!axis.logarithmic) return value;
    if (!(value > 0)) throw Error("plot", "a value on a logarithmic axis must be above 0", numberText(value));
    return std::log(value);
}

// 1, or 1/2 where the difference of the ends would overflow: what the ends and the value are taken times.
double unitOf(double low, double high) { return std::isfinite(high - low) ? 1 : 0.5; }

// The part of the way from the low end to the high one, and back.
double partOf(const Axis& axis, double value) {
    const double low = placed(axis, axis.low), high = placed(axis, axis.high), unit = unitOf(low, high);
    if (low == high) throw Error("plot", "the ends of an axis must differ", numberText(axis.low));
    return (unit * placed(axis, value) - unit * low) / (unit * high - unit * low);
}
double valueAt(const Axis& axis, double part) {
    const double low = placed(axis, axis.low), high = placed(axis, axis.high), unit = unitOf(low, high);
    const double value = (unit * low + part * (unit * high - unit * low)) / unit;
    return axis.logarithmic ? std::exp(value) : value;
}

// whole 10^exponent, rounded once, whatever its size.
double timesPowerOfTen(double whole, int exponent) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.0fe%d", whole, exponent);
    return portable::nearestDouble(text.data());
}

// Appends it, unless it is the one before it or beyond the ends by more than its rounding: of a narrow range that is no part.
void addTick(std::vector<double>& values, const Axis& axis, double value) {
    const double unit = unitOf(axis.low, axis.high), slack = 1e-9 * (unit * axis.high - unit * axis.low);
    if (unit * value < unit * axis.low - slack || unit * value > unit * axis.high + slack) return;
    if (values.empty() || value > values.back()) values.push_back(value);
}

std::vector<double> decades(const Axis& axis, int most) {
    const int first = int(std::ceil(std::log10(axis.low) - 1e-9)), last = int(std::floor(std::log10(axis.high) + 1e-9));
    const int step = 1 + (last - first) / most;
    std::vector<double> values;
    for (int exponent = first; exponent <= last; exponent += step) addTick(values, axis, timesPowerOfTen(1, exponent));
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
    // From steps too small upwards, until there are few enough; steps finer than the ends themselves would name one number
    // again and again. An end that is a multiple but for its rounding is one.
    const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
    const double widest = std::min(axis.high / most - axis.low / most, std::numeric_limits<double>::max());
    const double finest = std::max(widest, largest - std::nextafter(largest, 0.0));
    for (int exponent = int(std::floor(std::log10(finest))) - 1;; ++exponent) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = timesPowerOfTen(digit, exponent);
            const double first = std::ceil(axis.low / step - 1e-9), last = std::floor(axis.high / step + 1e-9);
            if (!(std::max(std::abs(first), std::abs(last)) <= 0x1p53) || last - first + 1 > most) continue;
            std::vector<double> values;
            for (int i = 0; first + i <= last; ++i)
                addTick(values, axis, timesPowerOfTen((first + i) * digit, exponent) + 0.0);
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
