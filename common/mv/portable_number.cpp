#include "mv/portable_number.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace mv::portable {
namespace {

// As printf's %e says it: d.ddd, and a power of ten.
struct Decimal {
    std::string digits;
    int exponent;
};

// With as few digits as read back as the same number.
Decimal shortestDecimal(double number) {
    char text[40];
    for (int more = 0; more <= 16; ++more) {
        std::snprintf(text, sizeof text, "%.*e", more, number);
        if (nearestDouble(text) == number) break;
    }
    const char* exponent = std::strchr(text, 'e');
    std::string digits(text, static_cast<std::size_t>(exponent - text));
    std::erase(digits, '.');
    return {digits, std::atoi(exponent + 1)};
}

std::string scientific(const Decimal& decimal) {
    std::string text = decimal.digits.substr(0, 1);
    if (decimal.digits.size() > 1) text.append(".").append(decimal.digits, 1);
    char exponent[8];
    std::snprintf(exponent, sizeof exponent, "e%+03d", decimal.exponent);
    return text + exponent;
}

// A whole number is written out as what it is, and not with zeros in the place of its last digits.
std::string fixed(const Decimal& decimal, double magnitude) {
    const int whole = decimal.exponent + 1;  // digits before the point
    if (whole >= static_cast<int>(decimal.digits.size())) {
        char text[400];
        std::snprintf(text, sizeof text, "%.0f", magnitude);
        return text;
    }
    if (whole <= 0) return "0." + std::string(static_cast<std::size_t>(-whole), '0') + decimal.digits;
    const auto point = static_cast<std::size_t>(whole);
    return decimal.digits.substr(0, point) + "." + decimal.digits.substr(point);
}

}  // namespace

#ifndef __EMSCRIPTEN__
double nearestDouble(const char* text) {
    char* end = nullptr;
    const double number = std::strtod(text, &end);
    return *end == '\0' ? number : std::numeric_limits<double>::quiet_NaN();
}
#endif

std::string shortestText(double number) {
    if (std::isnan(number)) return std::signbit(number) ? "-nan" : "nan";
    const std::string sign = std::signbit(number) ? "-" : "";
    const double magnitude = std::abs(number);
    if (std::isinf(magnitude)) return sign + "inf";
    const Decimal decimal = shortestDecimal(magnitude);
    const std::string one = fixed(decimal, magnitude), other = scientific(decimal);
    return sign + (one.size() <= other.size() ? one : other);
}

bool readFinite(std::string_view text, double& number) {
    const bool isDecimal =
        !text.empty() && text.front() != '+' && text.find_first_not_of("0123456789.eE+-") == std::string_view::npos;
    if (!isDecimal) return false;
    const double read = nearestDouble(std::string(text).c_str());
    if (!std::isfinite(read)) return false;
    const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
    if (read == 0 && mantissa.find_first_of("123456789") != std::string_view::npos) return false;
    number = read;
    return true;
}

}  // namespace mv::portable
