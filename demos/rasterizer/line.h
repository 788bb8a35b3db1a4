// Which pixels a line sets, by the lecture's methods, step by step. Pixels are numbered from the lower left one, (0, 0).
#pragma once
#include <vector>

#include "shared/pixel_step.h"

namespace mv {

enum class LineMethod {
    naive,      // y += m in float, rounded where it is drawn
    error,      // 1: the error e since the last step in y, in float
    shifted,    // 2: e starts at -1/2, so that it is compared with 0
    scaled,     // 3: times x2 - x1: no division, but halves
    bresenham,  // 4: times 2 as well: whole numbers only
    octants,    // the whole of Bresenham's method, for every direction
    smooth,     // two pixels a column, by how near the line passes. Source: Wu (1991).
};

// The pixels from (x1, y1) to (x2, y2), in the order in which they are set; by octants and smooth a line back sets the same ones,
// in the other order. But for octants and smooth the methods are the
// lecture's, made for x1 < x2 and slopes from 0 to 1: steeper lines have gaps, and others are wrong or empty.
std::vector<PixelStep> linePixels(LineMethod method, int x1, int y1, int x2, int y2);

}  // namespace mv
