// The maps that a GPU is given of a relief: colours, heights and normals.
#pragma once
#include "mv/image/picture.h"
#include "shared/relief.h"

namespace mv {

// Colours in red, green and blue, and the height in alpha: one repeat of the wall in size x size texels, or all of the
// orange in 2 size x size. Each texel is what is in its middle; row 0 has the smallest v. `mirrored` plays no part.
FloatPicture paintedMap(ReliefBody body, int size);
// Normals from the heights of such a map (mv/image/normal_map.h).
FloatPicture reliefNormals(const Relief& relief, const FloatPicture& painted);
// How far the normals of that map are from the true ones, as a root mean square over its texels, in degrees. `inBytes`:
// heights are rounded to 8 bits before, and normals after.
double normalMapError(const Relief& relief, int size, bool inBytes);

}  // namespace mv
