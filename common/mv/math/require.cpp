#include "mv/math/require.h"

#include <cmath>
#include <limits>

#include "mv/error.h"

namespace mv {
namespace {

template <typename V>
std::string listText(const V& v) {
    std::string text = "(";
    for (int i = 0; i < V::length(); ++i) text.append(i == 0 ? "" : ", ").append(numberText(v[i]));
    return text.append(")");
}

template <typename V>
[[noreturn]] void refuse(std::string_view subject, std::string_view name, const V& value) {
    throw Error(subject, std::string(name).append(" must be finite"), listText(value));
}

}  // namespace

std::string vectorText(const vec2& v) { return listText(v); }
std::string vectorText(const vec3& v) { return listText(v); }
std::string vectorText(const vec4& v) { return listText(v); }

void refuseInfinite(std::string_view subject, std::string_view name, double value) {
    throw Error(subject, std::string(name).append(" must be finite"), numberText(value));
}
void refuseInfinite(std::string_view subject, std::string_view name, const vec2& value) {
    refuse(subject, name, value);
}
void refuseInfinite(std::string_view subject, std::string_view name, const vec3& value) {
    refuse(subject, name, value);
}
void refuseInfinite(std::string_view subject, std::string_view name, const vec4& value) {
    refuse(subject, name, value);
}
void refuseInfinite(std::string_view subject, std::string_view name, const mat4& value) {
    // The first column that is not finite is named, so that the sentence stays short.
    int column = 0;
    while (column < 3 && isFinite(value[column])) ++column;
    refuse(subject, std::string(name).append(" column ").append(std::to_string(column)), value[column]);
}

bool fitsFloat(double value) { return std::abs(value) <= double(std::numeric_limits<float>::max()); }

void requireFitsFloat(std::string_view subject, std::string_view name, const vec3& value) {
    if (fitsFloat(value.x) && fitsFloat(value.y) && fitsFloat(value.z)) return;
    throw Error(subject, std::string(name).append(" must fit into floats"), vectorText(value));
}

void requirePositive(std::string_view subject, std::string_view name, double value) {
    // Written so that NaN, which compares false with everything, is refused.
    if (!(value > 0) || !std::isfinite(value)) {
        throw Error(subject, std::string(name).append(" must be greater than 0 and finite"), numberText(value));
    }
}

void requireRange(std::string_view subject, std::string_view name, int value, int low, int high) {
    if (value >= low && value <= high) return;
    const std::string rule = std::string(name) + " must be " + std::to_string(low) + " to " + std::to_string(high);
    throw Error(subject, rule, std::to_string(value));
}

}  // namespace mv
