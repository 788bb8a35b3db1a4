// Lines of words and numbers under each other, for formulas beside a picture.
#pragma once
#include <string>
#include <vector>

#include "mv/gl/text.h"

namespace mv {

// A cursor that goes down the picture. Places along a line are pixels from the column's left edge.
class TextColumn {
  public:
    // With its upper left corner at (x, y), pixels from the upper left corner of the picture.
    TextColumn(int x, int y, int textHeight) : x_(x), y_(y), height_(textHeight) {}
    // Words that begin there, or end there.
    void left(int from, const std::string& text, const vec4& color = vec4(0.1, 0.1, 0.1, 1));
    void right(int to, const std::string& text, const vec4& color = vec4(0.1, 0.1, 0.1, 1));
    // Moves to the next line, or further down.
    void next(int pixels = 0) { y_ += pixels > 0 ? pixels : height_ + 3; }

    std::vector<TextLine> lines;  // for drawText

  private:
    int x_, y_, height_;
};

// A number for a table: whole ones below 1000 without a point, else three decimals; from 1000 on nine digits, which say
// all that a float can.
std::string tableNumber(double value);

}  // namespace mv
