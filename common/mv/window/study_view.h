// A study as a plot: error to the right, time upwards, both logarithmic.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mv/study/choice.h"
#include "mv/window/gui.h"

namespace mv {

// The point under the mouse in the plot, and the rows that a click chooses from.
struct StudyPlotMarks {
    std::optional<std::size_t> here = {};    // the row of the present settings
    std::optional<StudyBound> bound = {};    // that was asked for, and
    std::optional<std::size_t> chosen = {};  // the row that keeps it
    std::vector<std::size_t> rows = {};      // that a bound chooses from
};

// The target of a click: a row, or a place of an axis.
struct StudyPlotClick {
    std::optional<std::size_t> row;
    std::optional<StudyBound> bound;
};

// Draws the rows of one scene, a line a method, with a legend below; the mouse over a point shows its row beside the plot, and a press by the keyboard
// takes the next one. A row's place is noted as "point METHOD PARAMETER", those of the axes as "error axis", "error axis 0" and "time axis".
StudyPlotClick showStudyPlot(const StudyRun& run, const std::string& scene, const StudyPlotMarks& marks, float scale);

// "map, 1 tap 1024"
std::string rowName(const StudyRow& row);

}  // namespace mv
