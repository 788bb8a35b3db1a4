#include "mv/gl/text_column.h"

#include <cmath>

#include "mv/formatted.h"

namespace mv {

void TextColumn::left(int from, const std::string& text, const vec4& color) {
    lines.push_back({x_ + from, y_, text, {.height = height_, .color = color, .background = vec4(0)}});
}

void TextColumn::right(int to, const std::string& text, const vec4& color) {
    left(to - textWidth(text, {.height = height_}), text, color);
}

std::string tableNumber(double value) {
    if (std::abs(value) >= 1000) return formatted("%.9g", value);
    if (value == std::round(value)) return formatted("%.0f", value + 0.0);  // and -0 is 0
    return formatted("%.3f", value);
}

}  // namespace mv
