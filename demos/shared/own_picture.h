// A picture of the user's own, as demos use it: a texture, a height map, surroundings.
#pragma once
#include <array>

#include "mv/geometry/cube_faces.h"
#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

// The picture in width x height texels of linear light, 0..1, four channels with alpha 1, the lower row first as textures have it.
// Each texel is the mean of exactly the area that it covers, parts of pixels counted as parts; proportions give way.
// The stored numbers are taken for sRGB, and their alpha is left out. Error: sides that no picture has.
FloatPicture ownTexels(const Picture& picture, int width, int height);

// The same as a height map: heights, 0 black to 1 white, are in alpha, and red, green and blue that of grey stone. Heights are
// numbers and no light: the mean is that of what is stored, weighed as Rec. 709 does.
FloatPicture ownHeights(const Picture& picture, int width, int height);

// A picture of all that is around, in one of two layouts.
enum class Surrounding {
    panorama,  // twice as wide as high: all round from left to right, from above to below; its middle is the direction -z
    faces,  // 4 : 3, a cube cut open: -x, -z, +x, +z in the middle row, +y above -z and -y below it; all else of one colour
};
// Error, with `subject`: it is of neither.
Surrounding surroundingOf(const Picture& picture, const char* subject);

// The same as a cube of size x size texels a face, for CubeMap, as it is stored, 0..1: each texel is looked up at its middle, between
// the pixels of the picture, which is shrunk before to about as many as the cube has. Error: it is of neither layout.
std::array<FloatPicture, cubeFaces> ownCube(const Picture& picture, int size);

}  // namespace mv
