// The pixels that a line sets, by the lecture's methods, step by step. Pixels are numbered from the lower left one, (0, 0).
#pragma once
#include <array>
#include <vector>

#include "mv/math/types.h"
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

enum class Thicken {
    columns,  // each pixel becomes a column of them, or a row where the line is steep: as OpenGL's own wide lines
    across,   // pixels whose middles are within half the thickness of the line
};

// The pixels from (x1, y1) to (x2, y2), in the order in which they are set; by octants and smooth a line back sets the same ones,
// in the other order. But for octants and smooth the methods are the
// lecture's, made for x1 < x2 and slopes from 0 to 1: steeper lines have gaps, and others are wrong or empty.
std::vector<PixelStep> linePixels(LineMethod method, int x1, int y1, int x2, int y2);

// A line of so many pixels, 1 or more, from its thin one: columns keep its order. A line of no length has none across it.
std::vector<PixelStep> thickLine(LineMethod method, Thicken thicken, int thickness, int x1, int y1, int x2, int y2);
// The corners of a line of that thickness between the middles of these pixels, as a GPU draws it.
std::array<vec2, 4> stripOf(double thickness, int x1, int y1, int x2, int y2);

}  // namespace mv
