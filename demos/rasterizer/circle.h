// The pixels that a circle sets, by four methods. Pixels are numbered from the lower left one, (0, 0).
#pragma once
#include <vector>

#include "shared/pixel_step.h"

namespace mv {

enum class CircleMethod {
    columns,   // in each column y = sqrt(r^2 - x^2) in float, rounded: gaps where the circle is steep
    mirrored,  // the same in one eighth of it, and its mirror images
    turned,    // a point turned by 1/r radian at a time, in float
    midpoint,  // one eighth and its mirror images, in whole numbers. Source: Bresenham (1977); Pitteway (1967).
};

// The pixels of the circle round the middle of pixel (x, y), each once but for `turned`. Their error is, by columns and mirrored, the
// height before it is rounded; by turned, how far out the point has come; by midpoint, what decides: below 0 the next pixel
// goes on, else one down. Radius 0 is one pixel. Error: a radius outside of 0 .. 2^20, or a middle beyond 2^30.
std::vector<PixelStep> circlePixels(CircleMethod method, int x, int y, int radius);

}  // namespace mv
