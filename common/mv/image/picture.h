// A picture in memory: eight bits per channel for what is shown and saved, floats for what is measured.
//
// Row 0 is the TOP row, as in PNG and on a page. OpenGL counts rows from the bottom: what glReadPixels returns,
// and what glTexImage2D is to receive, goes through flipRows.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mv {

// The largest side of a picture: what every OpenGL 3.3 driver at hand accepts as a framebuffer or texture.
inline constexpr int maximumPictureSide = 16384;

// One RGBA pixel, each channel 0..255; alpha 255 is opaque. Colours are not multiplied by alpha.
struct Pixel {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;

    bool operator==(const Pixel&) const = default;
};

// The place of pixel (x, y) of a picture of that width among its pixels, row after row from the top.
constexpr std::size_t pixelIndex(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

// RGBA, 8 bits each, row after row from the top, four bytes a pixel and no padding: the layout of
// glReadPixels(GL_RGBA, GL_UNSIGNED_BYTE), upside down. A default Picture has no pixels.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    Picture() = default;

    // A picture of width x height pixels, all transparent black.
    // Error unless both sides lie in 1..maximumPictureSide.
    Picture(int width, int height);

    // The pixel in column x, counted from the left, and row y, counted from the TOP.
    // Error unless 0 <= x < width and 0 <= y < height. For a loop over every pixel, run over rgba instead.
    [[nodiscard]] Pixel at(int x, int y) const;
    void set(int x, int y, Pixel pixel);

    bool operator==(const Picture&) const = default;
};

// A picture of measured quantities: `channels` floats a pixel, row after row from the top.
struct FloatPicture {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> values;

    FloatPicture() = default;

    // All zero. Error unless both sides lie in 1..maximumPictureSide and channels in 1..4.
    FloatPicture(int width, int height, int channels);

    bool operator==(const FloatPicture&) const = default;
};

// Refuses, with `subject` as the Error's subject, a picture whose sides are out of range or whose number of values
// does not fit them. The members are public, so whoever indexes by width and height asks first.
void checkPicture(const Picture& picture, std::string_view subject);
void checkPicture(const FloatPicture& picture, std::string_view subject);

// Turns the order of the rows about, in place: from OpenGL's (bottom row first) to ours, or back.
void flipRows(Picture& picture);
void flipRows(FloatPicture& picture);

// The picture made to fit into maximumWidth x maximumHeight with its proportions kept (to the nearest pixel, and never
// below one). Each result pixel is the mean of exactly the area it covers, parts of pixels counted as parts, so
// stripes and edges do not alias. The function only shrinks: a picture that fits comes back as it is.
// - Colours weigh by their alpha, so what a transparent pixel hides does not seep into its neighbours.
// - The mean is taken of the stored values, not of linear light. Sums are integers, so the bytes are the same
// everywhere. Error unless both maxima lie in 1..maximumPictureSide.
[[nodiscard]] Picture shrink(const Picture& picture, int maximumWidth, int maximumHeight);

}  // namespace mv
