// Words and pictures in the picture itself, headless too.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/gl/texture.h"

namespace mv {

struct TextStyle {
    int height = 16;  // of a line, pixels
    vec4 color{0.1, 0.1, 0.1, 1};
    vec4 background{1, 1, 1, 0.8};  // of a box behind the words; alpha 0: none
    bool operator==(const TextStyle&) const = default;
};

// Draws a line of UTF-8 text in DejaVu Sans with its upper left corner at (x, y), in pixels from the upper left corner
// of the picture, or in units where the frame counts these (FrameInfo::inUnits()), and so its height. Changes the current program, and switches depth test, culling and blending off.
void drawText(const FrameInfo& frame, int x, int y, std::string_view text, const TextStyle& style = {});

// A line of text for drawText: its upper left corner, in pixels from the upper left corner of the picture.
struct TextLine {
    int x, y;
    std::string text;
    TextStyle style = {};
    int beyond = 0;  // pixels by which the box is larger at each side, where a padding has grown with the words
    bool operator==(const TextLine&) const = default;
};

// The same for several lines, in their order; state is set once for all of them. The lines of the last sixteen
// different calls are kept: the same lines again are drawn without an upload, the same words elsewhere with that of
// their places.
void drawText(const FrameInfo& frame, std::span<const TextLine> lines);

// Lines that are placed in what the frame counts, in pixels. The words, not their boxes, are where they were: a box ends
// wordPadding pixels beyond, and more where the words have grown.
std::vector<TextLine> linesInPixels(const FrameInfo& frame, std::span<const TextLine> lines);

// The width in pixels that drawText needs for the text, its box included.
int textWidth(std::string_view text, const TextStyle& style = {});
// The height in pixels of a line with its box.
int textHeight(const TextStyle& style = {});

// Draws a picture with its upper left corner at (x, y), one pixel to a pixel, in what the frame counts from the upper left
// corner.
// Changes the same state as drawText. The last picture is kept: shown again, it is not uploaded again.
void showImage(const FrameInfo& frame, int x, int y, const Picture& picture);

// Deletes what the above keep between calls: their programs, words and picture; before the context goes.
void forgetText();

}  // namespace mv
