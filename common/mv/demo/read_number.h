// A number of a setting, read.
#pragma once
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "mv/portable_number.h"

namespace mv {

// Reads the whole of `text` as a number; nan, inf and hexadecimal are no settings.
template <class Number>
bool readNumber(std::string_view text, Number& number) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);  // which from_chars does not take
    if constexpr (portable::isNeeded && std::is_floating_point_v<Number>) {
        return portable::readFinite(text, number);
    } else {
        const auto end = text.data() + text.size();
        const auto result = std::from_chars(text.data(), end, number);
        if (result.ec != std::errc() || result.ptr != end) return false;
        return std::isfinite(static_cast<double>(number));
    }
}

}  // namespace mv
