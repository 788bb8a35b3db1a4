// The checks that stand at the door of every function in mv/math and mv/geometry: refuse now, with a sentence,
// rather than hand a NaN to the GPU, which shows it as an empty picture.
#pragma once
#include <string>
#include <string_view>

#include "mv/math/types.h"

namespace mv {

// "(1, 2, 3)", each number as numberText prints it.
std::string vectorText(const vec2& v);
std::string vectorText(const vec3& v);
std::string vectorText(const vec4& v);

// True when no element is NaN or infinite. x - x is 0 for every number and NaN for those, and a NaN stays in a sum: so
// one comparison answers for all elements.
inline bool isFinite(double x) { return x - x == 0; }
inline bool isFinite(const vec2& v) { return (v.x - v.x) + (v.y - v.y) == 0; }
inline bool isFinite(const vec3& v) { return (v.x - v.x) + (v.y - v.y) + (v.z - v.z) == 0; }
inline bool isFinite(const vec4& v) { return (v.x - v.x) + (v.y - v.y) + ((v.z - v.z) + (v.w - v.w)) == 0; }
inline bool isFinite(const mat4& m) {
    return isFinite((m[0] - m[0]) + (m[1] - m[1]) + ((m[2] - m[2]) + (m[3] - m[3])));
}

// The throwing half of requireFinite, kept out of the way of what is computed after it.
[[noreturn, gnu::cold, gnu::noinline]] void refuseInfinite(std::string_view subject, std::string_view name,
                                                           double value);
[[noreturn, gnu::cold, gnu::noinline]] void refuseInfinite(std::string_view subject, std::string_view name,
                                                           const vec2& value);
[[noreturn, gnu::cold, gnu::noinline]] void refuseInfinite(std::string_view subject, std::string_view name,
                                                           const vec3& value);
[[noreturn, gnu::cold, gnu::noinline]] void refuseInfinite(std::string_view subject, std::string_view name,
                                                           const vec4& value);
[[noreturn, gnu::cold, gnu::noinline]] void refuseInfinite(std::string_view subject, std::string_view name,
                                                           const mat4& value);

// Throws Error(subject, "<name> must be finite", value) when an element of a number, vector or matrix is NaN or
// infinite; of a matrix the first such column is named.
template <typename T>
void requireFinite(std::string_view subject, std::string_view name, const T& value) {
    if (!isFinite(value)) refuseInfinite(subject, name, value);
}

// False for NaN, infinity, and what is beyond float's range and would round to infinity.
bool fitsFloat(double value);

// Throws Error(subject, "<name> must fit into floats", value) unless every element fitsFloat(). Asked of the doubles: once it is a float, g++ 12 may take it for the
// number it was.
void requireFitsFloat(std::string_view subject, std::string_view name, const vec3& value);

// Throws Error(subject, "<name> must be greater than 0 and finite", value); NaN is refused too.
void requirePositive(std::string_view subject, std::string_view name, double value);

// Throws Error(subject, "<name> must be <low> to <high>", value).
void requireRange(std::string_view subject, std::string_view name, int value, int low, int high);

}  // namespace mv
