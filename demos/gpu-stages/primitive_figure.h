// A figure of the ten primitive types, a pane each. The figure shows how each type joins the same vertices.
#pragma once
#include <array>
#include <vector>

#include "mv/demo/made_for.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "primitive_types.h"

namespace mv {

class PrimitiveFigure {
  public:
    // Draws all types with `vertices` vertices. The program is in use, and has `clipFromPane`, `position` and `color`. Types that
    // have left the core are drawn as triangles. With `counts`, queries count the primitives when the number of vertices changes.
    void draw(const Frame& frame, const Program& program, int vertices, bool counts);
    // Writes the names of the types, the numbers of the vertices, and the counts of primitives.
    void label(const FrameInfo& frame, Drawing& drawing) const;
    // The primitives of the types of the core, all together.
    long counted() const;

  private:
    int vertices_ = 0;
    std::vector<Mesh> meshes_;
    std::array<long, primitiveTypes.size()> counts_{};
    MadeFor<int, bool> madeFor_;
};

}  // namespace mv
