// std::to_chars and std::from_chars of floating-point numbers, for standard libraries that lack them (libc++, which compiles
// what runs in a browser, has neither in version 13).
#pragma once
#include <charconv>
#include <string>
#include <string_view>

namespace mv::portable {

#ifdef __cpp_lib_to_chars
constexpr bool isNeeded = false;
#else
constexpr bool isNeeded = true;
#endif

// The shortest text that reads back as the same number, as std::to_chars(number) writes it: of the fixed and the scientific form
// the shorter, and of two as short the fixed.
std::string shortestText(double number);

// Reads the whole of `text` as a decimal number, as std::from_chars does: no sign +, no spaces, nothing hexadecimal. False, with
// `number` as it was: it is none, or it is not finite, or so small that nothing of it is left.
bool readFinite(std::string_view text, double& number);

// The double nearest to the decimal number that is all of `text`; NaN where it is none. Callers ask for nothing else
// that strtod reads (spaces, inf, a hexadecimal number): a page has another way of its own (web/portable_number.cpp).
double nearestDouble(const char* text);

}  // namespace mv::portable
