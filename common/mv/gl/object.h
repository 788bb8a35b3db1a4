// Ownership of one GL object: move-only, deleted with its owner.
#pragma once
#include <utility>

#include "mv/gl/functions.h"

namespace mv {

template <void (*destroy)(GLuint)>
class GlObject {
  public:
    GlObject() = default;
    explicit GlObject(GLuint id) : id_(id) {}
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~GlObject() {
        if (id_ != 0) destroy(id_);
    }
    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  private:
    GLuint id_ = 0;
};

inline void destroyBuffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void destroyVertexArray(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void destroyTexture(GLuint id) { glDeleteTextures(1, &id); }
inline void destroyFramebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void destroyRenderbuffer(GLuint id) { glDeleteRenderbuffers(1, &id); }
inline void destroyShader(GLuint id) { glDeleteShader(id); }
inline void destroyProgram(GLuint id) { glDeleteProgram(id); }

using Buffer = GlObject<destroyBuffer>;
using VertexArray = GlObject<destroyVertexArray>;
using TextureObject = GlObject<destroyTexture>;
using Framebuffer = GlObject<destroyFramebuffer>;
using Renderbuffer = GlObject<destroyRenderbuffer>;
using ShaderObject = GlObject<destroyShader>;
using ProgramObject = GlObject<destroyProgram>;

inline Buffer makeBuffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return Buffer(id);
}
inline VertexArray makeVertexArray() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return VertexArray(id);
}
inline TextureObject makeTexture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return TextureObject(id);
}
inline Framebuffer makeFramebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return Framebuffer(id);
}
inline Renderbuffer makeRenderbuffer() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return Renderbuffer(id);
}

}  // namespace mv
