// Tangents at the vertices of a mesh: the frames in which a normal map is told.
#pragma once
#include <cstddef>
#include <vector>

#include "mv/geometry/mesh_data.h"

namespace mv {

struct MeshTangents {
    // The same triangles, indexed. A vertex whose triangles have mirrored texture coordinates, and others that are not
    // mirrored, is there twice.
    MeshData mesh;
    // One for each position. xyz: of unit length, at right angles to the normal, along growing u. w: 1 or -1; the third
    // vector of the frame, along growing v, is w cross(normal, tangent). w is -1 where the texture is mirrored.
    std::vector<fvec4> tangents;
    std::size_t split = 0;  // vertices that are there twice now
    std::size_t free = 0;   // vertices at which no triangle says where u grows: any tangent across the normal, w = 1
};

// Each triangle at a vertex counts by its angle there (as in MikkTSpace). Vertices at exactly the same place, with the
// same normal and w, that differ in their texture coordinates only, share what their triangles say as far as it is
// within 60 degrees of what their own say: so the seam of a sphere is none, and at a pole each vertex keeps its own.
// Error: not triangles, no normals or no texCoords, a normal of 0, and what validate refuses.
MeshTangents meshTangents(const MeshData& mesh);

}  // namespace mv
