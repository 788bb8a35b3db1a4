// A figure of the ten primitive types, a pane each: what the same vertices are joined to.
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
    // Draws all types with so many vertices; the program is in use, and has `clipFromPane`, `position` and `color`. Types that
    // have left the core are drawn as triangles. `counts`: the primitives are counted by queries, when the number changes.
    void draw(const Frame& frame, const Program& program, int vertices, bool counts);
    // Their names, the numbers of the vertices, and how many primitives were counted.
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
