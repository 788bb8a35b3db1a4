// The way back from a pixel: the point of the world that is drawn there.
#pragma once
#include "mv/math/types.h"

namespace mv {

// The point of the space that clipFromWorld maps from which is drawn at a pixel of a viewport of width x height pixels with a
// depth of the depth buffer: x to the right and y up, as pixelFromNdc has them, depth 0 at near to 1 at far. Computed
// by elimination with the remainder mended, as viewVolumeCorners; the inverse of the matrix, multiplied out, loses a
// digit with each of far/near. Depths crowd at far: at distance z a depth is worth z^2 (far - near)/(near far) of
// distance. So half a step of a depth in 24 bits, 3e-8, is 3e-8 far/near of far there, 3 % at 1e6; what this function
// adds is 1e-16 far/near. Trap: rows of most image files, and mouse positions, count downwards. Refused: width or
// height below 1, NaN, infinity, a matrix without an inverse, a depth at infinity. Equals gluUnProject and
// glm::unProject, but for the viewport's corner, which is (0, 0), and their two matrices, which are one here.
vec3 unProject(const vec2& pixel, double depth, const mat4& clipFromWorld, int width, int height);

// The unit direction, in that space, of the ray through a pixel, away from the eye; of a parallel projection, in which nothing is
// behind the eye, the way on which clip space's z grows. The ray lies where the planes of the pixel's column and row
// meet, so it needs no depth, and the far plane may be anywhere, at infinity too. Refused: as above, and a matrix that
// flattens what it draws to a line.
vec3 directionThroughPixel(const vec2& pixel, const mat4& clipFromWorld, int width, int height);

}  // namespace mv
