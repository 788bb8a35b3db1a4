// A study as a plot: error to the right, time upwards, both logarithmic.
#pragma once
#include <optional>
#include <string>

#include "mv/run/study_data.h"
#include "mv/window/gui.h"

namespace mv {

// Draws the rows of one scene, a line a method, with a legend below; the mouse over a point shows its row. `here` is the
// row of the present settings. The row that was clicked. A row's place is noted as "point METHOD PARAMETER".
std::optional<std::size_t> showStudyPlot(const StudyRun& run, const std::string& scene, std::optional<std::size_t> here,
                                         float scale);

// "map, 1 tap 1024"
std::string rowName(const StudyRow& row);

}  // namespace mv
