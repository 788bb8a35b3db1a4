// What part of a pixel a triangle covers: by some of its points, as a graphics card's multisampling asks them, and exactly.
#pragma once
#include <array>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// The points of a pixel that are asked, from its lower left corner: its middle, or four of which no two are in one row or
// column of fourths. Direct3D fixes these four, and many a driver of OpenGL has them. Refused: a number other than 1 and 4.
std::vector<vec2> samplePlaces(int count);

// The triangle moved so that this point of each pixel comes to lie where the pixel's middle was.
std::array<vec2, 3> movedToMiddle(std::array<vec2, 3> corners, const vec2& place);

// The area of the triangle within pixel (x, y), 0..1.
double exactShare(const std::array<vec2, 3>& corners, int x, int y);

// The share of each pixel of a picture that the triangle covers, row by row from below, by so many points; and exactly.
std::vector<double> sharesByPlaces(const std::array<vec2, 3>& corners, int places, int columns, int rows);
std::vector<double> exactShares(const std::array<vec2, 3>& corners, int columns, int rows);

}  // namespace mv
