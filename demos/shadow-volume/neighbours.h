// Triangles with their neighbours, for a geometry shader that finds silhouettes by itself.
#pragma once
#include "mv/geometry/mesh_data.h"
#include "mv/geometry/shadow_volume.h"

namespace mv {

// The closed mesh, to be drawn as GL_TRIANGLES_ADJACENCY: of each triangle six indices, its corners as the 1st, 3rd and 5th, and
// after each the far corner of the triangle beyond the side that begins there. It has positions only.
MeshData withNeighbours(const ClosedMesh& closed);

}  // namespace mv
