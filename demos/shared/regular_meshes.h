// Bodies cut into triangles as regularly as they allow, and where they do not.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mv/geometry/mesh_data.h"
#include "mv/geometry/topology.h"
#include "mv/gl/drawing.h"

namespace mv {

struct RegularMesh {
    std::string name;
    MeshData mesh;
    Topology topology;
    MeshData irregular;  // points, with normals: the inner vertices at which another number of edges than 6 meet
};

// A sheet, a tube that is open at both ends, a ring and a ball, with `cells` cells along and around: within 1.5 of the
// origin. Refused: cells outside 3 .. 64.
std::vector<RegularMesh> regularMeshes(int cells);

// What is counted of a body, in words at the right side of its pane.
void labelBody(Drawing& drawing, const Pane& pane, const RegularMesh& body);

}  // namespace mv
