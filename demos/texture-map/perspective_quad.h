// A square of texture in perspective, and how far its texture slips where it is interpolated along the picture.
#pragma once
#include "mv/demo/frame.h"
#include "mv/math/types.h"

namespace mv {

// The square (u, v, 0) with u and v from 0 to 1, seen so that w is 1 along v = 0 and `ratio` along v = 1. Its lower and
// its upper edge stay at their heights in the picture, whatever the ratio.
mat4 clipFromQuad(double ratio);

// Between places (u, v, 1) of the square and places (x, y, 1) of the picture in pixels from its lower left corner, up to a
// factor; each is the other's inverse.
mat3 pixelFromQuad(double ratio, const Pane& pane);
mat3 quadFromPixel(double ratio, const Pane& pane);
// A place of the one as a place of the other.
vec2 projected(const mat3& map, const vec2& place);

// A point of the texture: where it is shown, and where it belongs, in pixels of the picture.
struct Slip {
    double pixels = 0;
    vec2 shown{0}, right{0};
};

// The largest slip of the square, cut into n x n cells with a diagonal from the lower left to the upper right, where texture
// coordinates are interpolated along the picture. In a triangle two of whose corners have the same w it lies on the longer
// of the two edges that lead to the third, where
//     pixels = length (sqrt(r) - 1) / (sqrt(r) + 1),
// r the ratio of the w's at its ends. The first row of cells has the largest: its edges are the longest, and so is
// its r. Refused: n below 1, a ratio below 1.
Slip largestSlip(double ratio, int n, const Pane& pane);

}  // namespace mv
