// A hilly sheet of 4 x 4 control points, and the net between them.
#pragma once
#include "mv/geometry/mesh_data.h"

namespace mv {

// 16 points, a unit apart in x and z, the row of the largest z first; with the net's normals (not of unit length) and its 18
// triangles as indices, fronts upwards.
MeshData controlNet();
// The points alone.
MeshData controlPoints();

}  // namespace mv
