// Words as pixels, before they become a texture.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "mv/math/types.h"

namespace mv {

inline constexpr int wordPadding = 4;  // pixels between the words and the end of their box

// How much of each pixel words cover, 0 .. 255; the upper row first, with the padding round them.
struct Coverage {
    int width, height;
    std::vector<std::uint8_t> parts;

    Coverage(int w, int h) : width(w), height(h), parts(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    std::uint8_t* row(int y) { return parts.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

// A line of UTF-8 text in DejaVu Sans, `height` pixels high without its padding.
Coverage coverageOf(std::string_view text, int height);
// The width of that, in pixels.
int widthOf(std::string_view text, int height);

// The words of several lines beside and under each other, for one texture.
struct WordSheet {
    Coverage all;
    std::vector<glm::ivec2> places;  // of the lines' upper left corners
};
WordSheet sheetOf(std::span<Coverage> lines);

}  // namespace mv
