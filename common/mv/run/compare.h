// Two settings of one knob side by side, and where their pictures differ.
#pragma once
#include <string>
#include <vector>

#include "mv/image/picture.h"
#include "mv/run/stage.h"

namespace mv {

// Draws frame `index` with the knob at each value, and lays the two pictures and their difference beside each other,
// each under its label. The knob keeps the second value.
// Error: as Stage::draw.
Picture compareSettings(Stage& stage, int index, const std::string& knob, const std::vector<std::string>& values);

}  // namespace mv
