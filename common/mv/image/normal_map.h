// Normal maps, made from height maps.
#pragma once
#include <functional>

#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

// The surface that a height map lies on.
struct HeightMapShape {
    double depth;  // from height 0 to height 1, in units
    // The sides of a texel of that row, along u and along v, in units: the same for all of a wall; on a sphere they are
    // shorter along u the nearer the row is to a pole.
    std::function<vec2(int row)> texel;
    bool repeatsU = true, repeatsV = true;  // the last column is beside the first, the last row beside the first
    int channel = 0;                        // of the picture, that is the height
};

// The unit normal of each texel in the frame (along u, along v, out of the surface), kept as 0.5 + 0.5 n in red, green
// and blue, alpha 1: by the difference of the two neighbours, or of three texels at an end that does not repeat, both
// of which are off by the square of a texel's side. As many texels as the heights, row 0 first as there: v grows with
// the row. Error: not 3 texels a side, a channel that there is not, a depth below 0, a texel's side that is not above
// 0, NaN.
FloatPicture normalMap(const FloatPicture& heights, const HeightMapShape& shape);

// The normal that a texel keeps, of unit length.
vec3 normalOf(const float* texel);

}  // namespace mv
