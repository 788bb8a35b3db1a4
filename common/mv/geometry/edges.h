// The edges of a body, as a draughtsman draws them.
#pragma once
#include "mv/geometry/mesh_data.h"

namespace mv {

// Lines along those edges of the triangles where the surface ends, or where two of its faces meet at an angle of more
// than `crease` degrees between their normals: of a box its twelve edges and no diagonal, of a sphere none. Each edge
// once; positions only. Vertices at exactly the same position count as one; triangles without area are
// passed over. A mesh without such an edge gives no positions.
// Refused: crease outside 0..180, NaN, and what validate refuses.
MeshData edgesOf(const MeshData& mesh, double crease = 30);

}  // namespace mv
