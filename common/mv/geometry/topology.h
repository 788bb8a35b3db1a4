// How the triangles of a mesh hang together: what is counted of it, whatever its shape.
#pragma once
#include <cstdint>
#include <vector>

#include "mv/geometry/mesh_data.h"

namespace mv {

// Vertices at exactly the same position are one here, as along the seam of a cylinder.
struct Topology {
    std::vector<fvec3> positions;       // of the vertices
    std::vector<int> degrees;           // of each, the edges that end there
    std::vector<bool> isInner;          // of each, whether the faces go all round it
    long edges = 0, boundaryEdges = 0;  // the latter have one face
    long faces = 0;

    long vertices() const { return static_cast<long>(positions.size()); }
    // V - E + F, Euler's number: 2 for a closed surface like a sphere, 0 like a torus, 1 for a sheet with one border.
    long euler() const { return vertices() - edges + faces; }
    // Inner vertices at which another number of edges than 6 meet.
    long irregular() const;
    // The sum of 6 - degree over the inner vertices and of 4 - degree over those of the border: 6 times Euler's number, in
    // any mesh of triangles.
    long missing() const;
};

// Triangles without area by their corners (two at one position) are passed over, as at the poles of a sphere.
// Refused: a mesh that is not of separate triangles, an edge of more than two faces, and what validate refuses.
Topology topologyOf(const MeshData& mesh);

}  // namespace mv
