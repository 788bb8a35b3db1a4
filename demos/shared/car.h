// The course's car: two boxes, a body and a cabin.
#pragma once
#include <array>

#include "mv/geometry/mesh_data.h"
#include "mv/math/types.h"

namespace mv {

// The matrices that take the cube -0.5..0.5 to the body and to the cabin. The car looks along +x with z up; it is 10
// long, 3 wide and 4 high, and stands on z = 0.
std::array<mat4, 2> carFromCubes();

// Both as one mesh with normals and colours, of that size times `size`, for who looks along -z with y up, as a camera and a
// PathFrame do. The cabin is lighter than the body: which way is up can be seen.
MeshData carLookingAlongMinusZ(double size);

}  // namespace mv
