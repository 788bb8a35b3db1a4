#include "mv/gl/target.h"

#include <algorithm>
#include <cstdint>

#include "mv/error.h"

namespace mv {
namespace {

Renderbuffer storage(GLenum format, int samples, int width, int height) {
    Renderbuffer buffer = makeRenderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    if (samples > 0) {
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
        GLint given = 0;
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
        if (given != samples) {  // drivers round up in silence
            throw Error("samples", "must be a number the driver has; it gives " + std::to_string(given) + " instead of",
                        std::to_string(samples));
        }
    } else {
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    }
    return buffer;
}

// One texel for each pixel, read as it is. Stored by glTexImage2D, which wants a layout of data even where none is given.
TextureObject texelPerPixel(GLenum format, GLenum channels, GLenum type, int width, int height,
                            const std::string& label) {
    TextureObject texture = makeTexture();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, channels, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    labelObject(GL_TEXTURE, texture.id(), label);
    return texture;
}

TextureObject colorTexture(GLenum format, int width, int height, const std::string& label) {
    const bool red = format == GL_R8 || format == GL_R32F, floats = format == GL_R32F || format == GL_RGBA32F;
    return texelPerPixel(format, red ? GL_RED : GL_RGBA, floats ? GL_FLOAT : GL_UNSIGNED_BYTE, width, height, label);
}

TextureObject depthTexture(GLenum format, int width, int height, const std::string& label) {
    const GLenum type = format == GL_DEPTH_COMPONENT16    ? GL_UNSIGNED_SHORT
                        : format == GL_DEPTH_COMPONENT32F ? GL_FLOAT
                                                          : GL_UNSIGNED_INT;
    return texelPerPixel(format, GL_DEPTH_COMPONENT, type, width, height, label + " depth");
}

}  // namespace

void requireComplete(const std::string& subject) {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    throw Error(subject, "must be complete; the driver refuses these buffers, or has no memory for them",
                std::to_string(status));
}

bool floatBlending() { return !isEs() || hasExtension("GL_EXT_float_blend"); }

bool floatTargets() { return !isEs() || hasExtension("GL_EXT_color_buffer_float"); }

int largestTargetSide() {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    GLint widest[2] = {0, 0};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, widest);
    return std::min({largest, widest[0], widest[1]});
}

Target::Target(int width, int height, Buffers buffers, const std::string& label)
    : width_(width), height_(height), buffers_(buffers) {
    const int largest = largestTargetSide();
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw Error("size",
                    "must be 1x1 .. " + std::to_string(largest) + "x" + std::to_string(largest) + " on this driver",
                    std::to_string(width) + "x" + std::to_string(height));
    }
    if (buffers.samples > 0) {
        GLint most = 0;
        glGetIntegerv(GL_MAX_SAMPLES, &most);
        if (buffers.samples > most) {
            throw Error("samples", "must be at most " + std::to_string(most) + " on this driver",
                        std::to_string(buffers.samples));
        }
    }
    if (buffers.texture && buffers.samples > 0) {
        throw Error(label, "must be a texture or have samples, not both", std::to_string(buffers.samples));
    }
    if (buffers.stencil && (buffers.depthTexture || buffers.depthFormat != GL_DEPTH_COMPONENT24)) {
        throw Error(label, "must have 24 bits of depth, not in a texture, where it has a stencil buffer");
    }
    if (buffers.depthTexture && (!buffers.depth || buffers.samples > 0)) {
        throw Error(label, "must have a depth buffer without samples to have it as a texture");
    }
    framebuffer_ = makeFramebuffer();
    if (buffers.texture) {
        colorTexture_ = colorTexture(buffers.color, width, height, label);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colorTexture_.id(), 0);
    } else {
        color_ = storage(buffers.color, buffers.samples, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.id());
    }
    if (buffers.depthTexture) {
        depthTexture_ = depthTexture(buffers.depthFormat, width, height, label);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depthTexture_.id(), 0);
    } else if (buffers.depth || buffers.stencil) {
        // Stencil alone is not a format every driver completes; beside depth it always is.
        depthStencil_ =
            storage(buffers.stencil ? GL_DEPTH24_STENCIL8 : buffers.depthFormat, buffers.samples, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, buffers.stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                                  GL_RENDERBUFFER, depthStencil_.id());
    }
    requireComplete("framebuffer " + label);
    labelObject(GL_FRAMEBUFFER, framebuffer_.id(), label);
    if (buffers.samples > 0) {
        single_ = makeFramebuffer();
        singleColor_ = storage(buffers.color, 0, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, single_.id());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, singleColor_.id());
        requireComplete("framebuffer " + label + " resolved");
        labelObject(GL_FRAMEBUFFER, single_.id(), label + " resolved");
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    }
    glViewport(0, 0, width, height);
}

bool Target::fit(int width, int height, const Buffers& buffers, const std::string& label) {
    if (framebuffer_ && width_ == width && height_ == height && buffers_ == buffers) return false;
    *this = Target(width, height, buffers, label);
    return true;
}

void Target::begin(int width, int height, const Buffers& buffers, const std::string& label) {
    if (!fit(width, height, buffers, label)) bind();
}

void Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
}

GLuint Target::resolved() const {
    if (!single_) return framebuffer_.id();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return single_.id();
}

void Target::bindColor(int unit) const {
    if (!colorTexture_) throw Error("target", "must be made with Buffers::texture to be read by a draw");
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, colorTexture_.id());
}

void Target::bindImage(int unit) const {
    if (!colorTexture_ || buffers_.color != GL_RGBA8)
        throw Error("target", "must be made with Buffers::texture, of GL_RGBA8, to be written as an image");
    glBindImageTexture(static_cast<GLuint>(unit), colorTexture_.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
}

void Target::bindDepth(int unit) const {
    if (!depthTexture_) throw Error("target", "must be made with Buffers::depthTexture to be read by a draw");
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, depthTexture_.id());
}

Picture Target::read() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved());
    Picture picture = readBound();
    bind();
    return picture;
}

Picture Target::readBound() const {
    Picture picture(width_, height_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    flipRows(picture);
    return picture;
}

std::vector<float> Target::readRed() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    std::vector<float> values(width * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    if (buffers_.color == GL_R32F || buffers_.color == GL_RGBA32F) {
        glReadPixels(0, 0, width_, height_, GL_RED, GL_FLOAT, values.data());
    } else {  // ES reads bytes as bytes alone, and four channels of them
        std::vector<std::uint8_t> bytes(4 * values.size());
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(bytes[4 * i]) / 255;
    }
    bind();
    for (std::size_t row = 0; row < height / 2; ++row) {  // GL counts rows from below
        std::swap_ranges(values.begin() + static_cast<std::ptrdiff_t>(row * width),
                         values.begin() + static_cast<std::ptrdiff_t>((row + 1) * width),
                         values.begin() + static_cast<std::ptrdiff_t>((height - 1 - row) * width));
    }
    return values;
}

void Target::blitToWindow(int x, int y) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace mv
