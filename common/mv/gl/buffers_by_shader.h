// Depths and stencils where OpenGL ES 3.0 gives back none: shaders make colours of them, which it does.
#pragma once
#include <cstdint>
#include <vector>

#include "mv/gl/functions.h"

namespace mv {

// How a buffer of a framebuffer is stored.
struct DepthBuffer {
    GLenum format = GL_DEPTH_COMPONENT24;  // GL_DEPTH_COMPONENT16, 24 or 32F, or GL_DEPTH24_STENCIL8
    GLuint renderbuffer = 0;               // where it is one; else the texture
    GLuint texture = 0;
};

// Depths 0..1, of `framebuffer` without samples, the lower row first, to 24 bits. Depths are copied by a blit into a texture of
// their own: a renderbuffer cannot be sampled, and a texture may compare instead of telling. The state is as before; which
// framebuffers and renderbuffer are bound, and the viewport, is not.
std::vector<float> depthsByShader(GLuint framebuffer, const DepthBuffer& buffer, int width, int height);

// Stencil values of a buffer of GL_DEPTH24_STENCIL8, the lower row first: a draw for each bit passes where it is set. The same is
// left as it was.
std::vector<std::uint8_t> stencilsByShader(const DepthBuffer& buffer, int width, int height);

}  // namespace mv
