// How the lines of a study's plot are told apart, in the SVG and in the window alike: by colour, mark and dash.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace mv {

// A colour as 0xRRGGBB.
using Rgb = std::uint32_t;

// The colours of Okabe and Ito, chosen to be told apart with each kind of colour blindness, without their yellow, which
// hardly shows on white. The first is the ink: what writes on the plot's ground, black on white and white on black.
inline constexpr Rgb blackInk = 0x000000, whiteInk = 0xFFFFFF;
inline constexpr std::array<Rgb, 6> seriesColors{0xD55E00, 0x56B4E9, 0x009E73, 0xCC79A7, 0xE69F00, 0x0072B2};

enum class Mark {
    disc,
    square,
    triangle,
    diamond,
    wedge,
    openSquare,
    openTriangle,
    openDiamond,
    openWedge,
    cross,
    plus,
    pentagon,
    star
};
inline constexpr std::size_t markCount = 13;

enum class Dash { solid, dashed, dotted };

struct SeriesLook {
    bool ink;   // drawn in the ink; else in `color`
    Rgb color;  // 0 for the ink
    Mark mark;
    Dash dash;
    Rgb on(Rgb inkColor) const { return ink ? inkColor : color; }
};

// The colour of the series of that index, from 0. Colour and dash together are another for each of 21; the marks are
// another for each of 13, so that two that share a colour differ in both.
constexpr SeriesLook seriesLook(std::size_t index) {
    constexpr std::size_t colors = seriesColors.size() + 1;
    const std::size_t color = index % colors;
    return {.ink = color == 0,
            .color = color == 0 ? 0 : seriesColors[color - 1],
            .mark = static_cast<Mark>(index % markCount),
            .dash = static_cast<Dash>(index / colors % 3)};
}

}  // namespace mv
