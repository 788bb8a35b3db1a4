// Bodies cut into triangles as regularly as possible, and the vertices at which no body can be regular.
#pragma once
#include <string>
#include <vector>

#include "mv/demo/made_for.h"
#include "mv/geometry/mesh_data.h"
#include "mv/geometry/topology.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"

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

// A figure of them, a pane each.
class RegularFigure {
  public:
    // Draws the bodies, turned; the program is in use, and has `clipFromWorld`, `position` and `normal`.
    void draw(const Frame& frame, const mat4& turn, const Program& program, int cells);
    // Writes the counts of each body, and draws red dots where those of its irregular vertices are that face the eye.
    void label(const FrameInfo& frame, const mat4& turn, Drawing& drawing) const;
    // Irregular vertices, all together.
    long irregular() const;

  private:
    std::vector<RegularMesh> bodies_;
    std::vector<Mesh> meshes_;
    MadeFor<int> madeFor_;
};

}  // namespace mv
