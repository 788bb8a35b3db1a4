// A number in words, by a format of printf.
#pragma once
#include <cstdio>
#include <string>

namespace mv {

// printf's format for one double, with the words round it: formatted("%.3f px", 0.5) is "0.500 px".
inline std::string formatted(const char* format, double value) {
    std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, value)), ' ');
    std::snprintf(text.data(), text.size() + 1, format, value);
    return text;
}

}  // namespace mv
