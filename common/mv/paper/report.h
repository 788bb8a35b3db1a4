// The report of a drawn frame, as text or as JSON.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mv/show/frame_times.h"
#include "mv/show/stage.h"

namespace mv {

// The largest size of any entry.
inline double largestEntry(const mat4& matrix) {
    double largest = 0;
    for (int i = 0; i < 16; ++i) largest = std::max(largest, std::abs(matrix[i / 4][i % 4]));
    return largest;
}

// 0 for what is left of roundings beside the largest number that it stands with; never -0.
inline double withoutRounding(double value, double largest) {
    return (value < 0 ? -value : value) < 1e-12 * largest ? 0 : value + 0.0;
}

// The draws of a frame that was stopped, what each is made of, and its buffers, a line each.
std::string stepsText(const FrameSteps& steps);

// The driver's remarks, a line each with `before` before it.
std::string remarksText(const std::vector<DriverRemark>& remarks, const std::string& before);

std::string reportText(Stage& stage, int index, const FrameTimes& times);
std::string reportJson(Stage& stage, int index, const FrameTimes& times);

// The knobs of a demo: names, ranges, initial and present values, and why one does nothing now.
std::string knobsText(const Demo& demo);
// Its presets: names, what to look for, settings; "" where it has none.
std::string presetsText(const DemoInfo& info);
// Both.
std::string knobsJson(const DemoInfo& info, const Demo& demo);

// A matrix laid out as on paper, row by row.
std::string matrixText(const mat4& matrix);

}  // namespace mv
