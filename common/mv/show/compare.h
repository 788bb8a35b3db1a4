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

// Draws frame `index` with each value of one knob beside each other or, with two knobs, with each value of the second below
// each other; each picture under a label of its settings. The knobs keep their last values. Error: as Stage::draw, with the
// settings; or there is no room for them all in the largest picture that this driver draws.
struct KnobValues {
    std::string knob;
    std::vector<std::string> values;
};
Picture stripOf(Stage& stage, int index, const std::vector<KnobValues>& strip);

// "difference: 2.31 % of pixels, at most 87 of 255"
std::string differenceText(const Difference& difference);

// Words beside the stage's picture, as much larger as its figures' are.
TextStyle labelStyle(const Stage& stage, int index, TextStyle style = {});

// Words of ordinary height, or of a smaller one (down to 8 pixels) where one of the lines is wider than so many pixels.
TextStyle fittedStyle(const std::vector<std::string>& lines, int width, TextStyle style = {});

}  // namespace mv
