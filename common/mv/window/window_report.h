// The common part of the reports of all screens of the window.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "mv/window/gui.h"
#include "mv/window/screen.h"

namespace mv {

// {"settled": true, "hidden": false, "mouse": "300,290", "keys": 3, ...}
nlohmann::ordered_json windowJson(const WindowState& state);
// Each widget's "left,top,right,bottom" in window coordinates.
nlohmann::ordered_json placesJson(const Places& places);
// The same as windowJson, as lines of a report in words.
std::string windowText(const WindowState& state);

// Writes to standard output, at once. Error: it cannot be written.
void printReport(const std::string& text);

}  // namespace mv
