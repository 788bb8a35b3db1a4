// Where vertices went: gl_Position of each, read back by transform feedback.
#pragma once
#include <vector>

#include "mv/gl/mesh.h"

namespace mv {

// Draws the mesh with the current program and uniforms, with the rasterizer switched off, and returns gl_Position of
// every vertex, in the floats that the shader wrote; strips and fans as the separate triangles they stand for, indexed
// meshes in the order of their indices. Draws no pixel, changes no state, and is no part of the frame's counted work.
// Equals glBeginTransformFeedback .. glEndTransformFeedback and mapping the buffer. Error: the driver maps no buffer.
std::vector<fvec4> transformedPositions(const Mesh& mesh);

}  // namespace mv
