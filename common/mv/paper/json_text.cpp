#include "mv/paper/json_text.h"

#include <cmath>

#include "mv/error.h"

namespace mv {

std::string jsonQuoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            quoted += '\\';
            quoted += letter;
        } else if (letter == '\n') {
            quoted += "\\n";
        } else if (code < 0x20) {
            constexpr const char* digits = "0123456789abcdef";
            quoted.append("\\u00") += digits[code / 16];
            quoted += digits[code % 16];
        } else {
            quoted += letter;
        }
    }
    return quoted += '"';
}

JsonText& JsonText::value(std::string_view name, std::string_view text) {
    if (!open_.empty()) {
        text_ += isEmpty_ ? "\n" : ",\n";
        text_.append(2 * open_.size(), ' ');
    }
    // An array's have no names, and a name of an object can be empty.
    if (!open_.empty() && open_.back() == '}') text_ += jsonQuoted(name) + ": ";
    text_ += text;
    isEmpty_ = false;
    return *this;
}

JsonText& JsonText::add(std::string_view name, double number) {
    return std::isfinite(number) ? value(name, numberText(number)) : addNull(name);
}

JsonText& JsonText::begin(char bracket, std::string_view name) {
    value(name, {&bracket, 1});
    open_ += bracket == '{' ? '}' : ']';
    isEmpty_ = true;
    return *this;
}

JsonText& JsonText::end() {
    const char bracket = open_.back();
    open_.pop_back();
    if (!isEmpty_) {
        text_ += '\n';
        text_.append(2 * open_.size(), ' ');
    }
    text_ += bracket;
    isEmpty_ = false;
    return *this;
}

}  // namespace mv
