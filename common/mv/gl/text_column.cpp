#include "mv/gl/text_column.h"

#include <cmath>

namespace mv {

void TextColumn::left(int from, const std::string& text, const vec4& color) {
    lines.push_back({x_ + from, y_, text, {.height = height_, .color = color, .background = vec4(0)}});
}

void TextColumn::right(int to, const std::string& text, const vec4& color) {
    left(to - textWidth(text, {.height = height_}), text, color);
}

std::string tableNumber(double value) {
    if (std::abs(value) >= 1000) return rounded("%.9g", value);
    if (value == std::round(value)) return rounded("%.0f", value + 0.0);  // and -0 is 0
    return rounded("%.3f", value);
}

}  // namespace mv
