#include "mv/gl/buffers_by_shader.h"

#include <algorithm>
#include <string>

#include "mv/gl/object.h"
#include "mv/gl/program.h"
#include "mv/gl/state.h"
#include "mv/gl/target.h"

namespace mv {
namespace {

// A triangle that covers the whole viewport, without vertices in memory.
constexpr const char* coverVertex = R"(
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";
// 24 bits of a depth, eight in each colour. (The minimum is for 1 itself, which no rounding may carry on.)
constexpr const char* depthFragment = R"(
uniform sampler2D depths;
out vec4 fragColor;
void main() {
    float depth = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    uint bits = min(uint(round(clamp(depth, 0.0, 1.0) * 16777215.0)), 16777215u);
    fragColor = vec4(float(bits >> 16u), float((bits >> 8u) & 255u), float(bits & 255u), 255.0) / 255.0;
}
)";
constexpr const char* bitFragment = R"(
uniform float value;
out vec4 fragColor;
void main() { fragColor = vec4(value); }
)";

// A framebuffer of RGBA8 to draw into and read from.
struct Colors {
    Framebuffer framebuffer = makeFramebuffer();
    Renderbuffer storage = makeRenderbuffer();
    Colors(int width, int height) {
        glBindRenderbuffer(GL_RENDERBUFFER, storage.id());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage.id());
        glViewport(0, 0, width, height);
    }
    static std::vector<std::uint8_t> read(int width, int height) {
        std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return rgba;
    }
};

void attach(const DepthBuffer& buffer) {
    const GLenum where = buffer.format == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
    if (buffer.renderbuffer != 0)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer.renderbuffer);
    if (buffer.texture != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, buffer.texture, 0);
    requireComplete("framebuffer that reads a buffer");
}

// As glTexImage2D wants it, though no data are given.
GLenum typeOf(GLenum format) {
    switch (format) {
        case GL_DEPTH_COMPONENT16:
            return GL_UNSIGNED_SHORT;
        case GL_DEPTH_COMPONENT32F:
            return GL_FLOAT;
        case GL_DEPTH24_STENCIL8:
            return GL_UNSIGNED_INT_24_8;
        default:
            return GL_UNSIGNED_INT;
    }
}

}  // namespace

std::vector<float> depthsByShader(GLuint framebuffer, const DepthBuffer& buffer, int width, int height) {
    const StateScope scope;
    restoreInitialState();  // no scissor cuts what follows, and no blending mixes it
    const TextureObject copy = makeTexture();
    const GLenum channels = buffer.format == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT;
    glBindTexture(GL_TEXTURE_2D, copy.id());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(buffer.format), width, height, 0, channels, typeOf(buffer.format),
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const Framebuffer copied = makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, copied.id());
    attach({buffer.format, 0, copy.id()});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);

    const Colors colors(width, height);
    const Program program = Program::fromText("depths", coverVertex, depthFragment);
    const VertexArray none = makeVertexArray();
    glUseProgram(program.id());  // as the texture of unit 0; not use(): the demo's own stays the one that it sets
    glBindVertexArray(none.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const std::vector<std::uint8_t> rgba = Colors::read(width, height);
    std::vector<float> depths(rgba.size() / 4);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const int bits = (rgba[4 * i] << 16) | (rgba[4 * i + 1] << 8) | rgba[4 * i + 2];
        depths[i] = static_cast<float>(bits / 16777215.0);
    }
    return depths;
}

std::vector<std::uint8_t> stencilsByShader(const DepthBuffer& buffer, int width, int height) {
    const StateScope scope;
    restoreInitialState();
    const Colors colors(width, height);
    attach(buffer);
    glClear(GL_COLOR_BUFFER_BIT);
    const Program program = Program::fromText("stencil", coverVertex, bitFragment);
    const VertexArray none = makeVertexArray();
    glUseProgram(program.id());  // not use(): the demo's own stays the one that it sets
    const GLint value = glGetUniformLocation(program.id(), "value");
    glBindVertexArray(none.id());
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int bit = 0; bit < 8; ++bit) {
        const GLuint mask = 1U << bit;
        glStencilFunc(GL_EQUAL, static_cast<GLint>(mask), mask);
        glUniform1f(value, static_cast<float>(mask / 255.0));
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    const std::vector<std::uint8_t> rgba = Colors::read(width, height);
    std::vector<std::uint8_t> values(rgba.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = rgba[4 * i];
    return values;
}

}  // namespace mv
