// The fate of a draw's triangles.
#pragma once
#include <vector>

#include "mv/gl/mesh.h"

namespace mv {

struct TriangleCount {
    long submitted = 0;
    long outside = 0;    // all three corners beyond one plane of the clip volume
    long culled = 0;     // not outside, and discarded by the face culling in force
    long surviving = 0;  // go on to the rasterizer
};

// Which faces are discarded: GL_CULL_FACE, glCullFace and glFrontFace.
struct FaceCulling {
    bool isOn;
    GLenum face, front;
};
// As OpenGL has them now; a browser answers when all is drawn that was asked for before.
FaceCulling currentCulling();

// The fate of these clip-space triangles, three corners each, by that culling.
TriangleCount sortTriangles(const std::vector<fvec4>& corners, const FaceCulling& culling = currentCulling());

// Draws the mesh once more with the current program and uniforms, with the rasterizer switched off, reads back where
// gl_Position went (transform feedback) and counts on the CPU, by the current GL_CULL_FACE, glCullFace and glFrontFace.
// The driver's own statistics are not used: they count other things on each driver. Draws no pixel and changes no
// state.
TriangleCount countTriangles(const Mesh& mesh);

}  // namespace mv
