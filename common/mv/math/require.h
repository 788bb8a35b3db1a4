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

// True when no element is NaN or infinite.
bool isFinite(const vec2& v);
bool isFinite(const vec3& v);
bool isFinite(const vec4& v);
bool isFinite(const mat4& m);

// Each throws Error(subject, "<name> must be finite", value) when an element is NaN or infinite.
void requireFinite(std::string_view subject, std::string_view name, double value);
void requireFinite(std::string_view subject, std::string_view name, const vec2& value);
void requireFinite(std::string_view subject, std::string_view name, const vec3& value);
void requireFinite(std::string_view subject, std::string_view name, const vec4& value);
void requireFinite(std::string_view subject, std::string_view name, const mat4& value);

// Throws Error(subject, "<name> must be greater than 0 and finite", value); NaN is refused too.
void requirePositive(std::string_view subject, std::string_view name, double value);

// Throws Error(subject, "<name> must be <low> to <high>", value).
void requireRange(std::string_view subject, std::string_view name, int value, int low, int high);

}  // namespace mv
