// Which widget shows each knob, for a page that makes its own of HTML.
#pragma once
#include <string>

#include "mv/demo/demo.h"
#include "mv/paper/json_text.h"

namespace mv {

// Adds {"kind": "number" with "low", "high", "whole", "logarithmic", "orZero"; "switch"; "choice" with "options" of "word" and
// "meaning"; "file", with the endings that it "accept"s; or "words"; and "buttons" of "label" and "enabled"} for each knob, by its name.
void addWidgets(JsonText& json, const Demo& demo);

// Presses that button of the knob; whether the knob moved.
bool pressButton(Knob& knob, const std::string& label);

}  // namespace mv
