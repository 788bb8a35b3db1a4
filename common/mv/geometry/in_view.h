// Whether anything of a mesh can be seen at all.
#pragma once
#include "mv/geometry/mesh_data.h"

namespace mv {

// True when a part of the mesh lies in OpenGL's clip volume under this matrix: some length of a line, some area of a
// triangle, or a point. Other objects that hide it, and face culling, are not considered, nor whether a part is large
// enough to cover a pixel. For a lesson's check(): a picture of nothing is refused rather than shown. Refuses what
// validate refuses, and a matrix with NaN or infinity.
bool isInView(const MeshData& mesh, const mat4& clipFromModel);

}  // namespace mv
