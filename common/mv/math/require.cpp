#include "mv/math/require.h"

#include <cmath>

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
bool allFinite(const V& v) {
    for (int i = 0; i < V::length(); ++i) {
        if (!std::isfinite(v[i])) return false;
    }
    return true;
}

template <typename V>
void requireAllFinite(std::string_view subject, std::string_view name, const V& value) {
    if (!allFinite(value)) throw Error(subject, std::string(name).append(" must be finite"), listText(value));
}

}  // namespace

std::string vectorText(const vec2& v) { return listText(v); }
std::string vectorText(const vec3& v) { return listText(v); }
std::string vectorText(const vec4& v) { return listText(v); }

bool isFinite(const vec2& v) { return allFinite(v); }
bool isFinite(const vec3& v) { return allFinite(v); }
bool isFinite(const vec4& v) { return allFinite(v); }
bool isFinite(const mat4& m) { return allFinite(m[0]) && allFinite(m[1]) && allFinite(m[2]) && allFinite(m[3]); }

void requireFinite(std::string_view subject, std::string_view name, double value) {
    if (!std::isfinite(value)) throw Error(subject, std::string(name).append(" must be finite"), numberText(value));
}
void requireFinite(std::string_view subject, std::string_view name, const vec2& value) {
    requireAllFinite(subject, name, value);
}
void requireFinite(std::string_view subject, std::string_view name, const vec3& value) {
    requireAllFinite(subject, name, value);
}
void requireFinite(std::string_view subject, std::string_view name, const vec4& value) {
    requireAllFinite(subject, name, value);
}
void requireFinite(std::string_view subject, std::string_view name, const mat4& value) {
    if (isFinite(value)) return;
    // The first column that is not finite is named, so that the sentence stays short.
    for (int column = 0; column < 4; ++column) {
        requireAllFinite(subject, std::string(name).append(" column ").append(std::to_string(column)), value[column]);
    }
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
