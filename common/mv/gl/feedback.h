// The way of vertices: gl_Position of each, read back by transform feedback.
#pragma once
#include <functional>
#include <vector>

#include "mv/gl/mesh.h"

namespace mv {

// Draws the mesh with the current program and uniforms, with the rasterizer switched off, and returns gl_Position of
// every vertex, in the floats that the shader wrote; strips and fans as the separate triangles they stand for, indexed
// meshes in the order of their indices. Draws no pixel, changes no state, and is no part of the frame's counted work.
// Equals glBeginTransformFeedback .. glEndTransformFeedback and mapping the buffer. Error: the driver maps no buffer.
std::vector<fvec4> transformedPositions(const Mesh& mesh);

// The count by a query of these draws: GL_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED. ES 3.0 counts neither.
long countedBy(GLenum query, const std::function<void()>& draw);

// The primitives that a draw sends to the rasterizer, whichever stages it goes through, counted three times over.
struct Captured {
    long generated = 0;            // primitives, by a query of their number, GL_PRIMITIVES_GENERATED
    long written = 0;              // primitives, by a query of those that transform feedback wrote
    std::vector<fvec4> positions;  // gl_Position of the corners that were found in the buffer
};

// Makes these draws twice, with the rasterizer switched off, and returns what came out of them. `primitive` is what their
// program gives: Program::primitiveOut(). Draws no pixel, changes no state, and is no part of the frame's counted work.
// Error: the driver maps no buffer. Trap: ES 3.0 counts no generated primitives; has(beyond_es::countingQueries) is to be
// asked before.
Captured captured(GLenum primitive, const std::function<void()>& draw);

}  // namespace mv
