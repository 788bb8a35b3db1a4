// Two settings of one knob side by side, and where their pictures differ.
#pragma once
#include <string>
#include <vector>

#include "mv/gl/text.h"
#include "mv/image/compare.h"
#include "mv/image/picture.h"
#include "mv/show/stage.h"

namespace mv {

// Refuses pictures of which three do not fit beside each other into the largest that this driver draws, and names the size
// that does.
void requireRoomToCompare(int width, int height);

// Draws frame `index` with the knob at each value, and lays the two pictures and their difference beside each other,
// each under its label. The knob keeps the second value.
// Error: as Stage::draw.
Picture compareSettings(Stage& stage, int index, const std::string& knob, const std::vector<std::string>& values);

// "difference: 2.31 % of pixels, at most 87 of 255"
std::string differenceText(const Difference& difference);

// Words of ordinary height, or of a smaller one (down to 8 pixels) where one of the lines is wider than so many pixels.
TextStyle fittedStyle(const std::vector<std::string>& lines, int width, TextStyle style = {});

}  // namespace mv
