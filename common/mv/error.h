// The one exception of mvgl: what could not be done, as "subject: rule, value".
#pragma once
#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mv/portable_number.h"

namespace mv {

// Something that can go wrong at run time: an impossible request, a missing file, a failed shader.
// what() reads "subject: rule, value"; the rule says what would have been right, so it is the remedy too.
class Error : public std::runtime_error {
  public:
    Error(std::string_view subject, std::string_view rule, std::string_view value = {})
        : std::runtime_error(sentence(subject, rule, value)) {}

  private:
    static std::string sentence(std::string_view subject, std::string_view rule, std::string_view value) {
        std::string text(subject);
        text.append(": ").append(rule);
        if (!value.empty()) text.append(", ").append(value);
        return text;
    }
};

// The shortest text that reads back as exactly the same number ("0.1", "1e+20", "nan").
inline std::string numberText(double value) {
    if (value != value) return "nan";  // whatever its sign bit
#ifdef __cpp_lib_to_chars
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
#else
    return portable::shortestText(value);
#endif
}

}  // namespace mv
