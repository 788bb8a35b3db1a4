#include "targets.h"

#include "mv/gl/gl.h"

namespace mv {
namespace {

GLenum typeOf(GLenum format) {
    if (format == GL_RGBA16F) return GL_HALF_FLOAT;
    return format == GL_RGB10_A2 ? GL_UNSIGNED_INT_2_10_10_10_REV : GL_UNSIGNED_BYTE;
}

TextureObject texture(GLenum format, GLenum channels, GLenum type, int width, int height, const std::string& label) {
    TextureObject made = makeTexture();
    glBindTexture(GL_TEXTURE_2D, made.id());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, channels, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    labelObject(GL_TEXTURE, made.id(), label);
    return made;
}

void bind(const TextureObject& texture, int unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

}  // namespace

void Targets::begin(int width, int height, const std::vector<GLenum>& formats, bool hasDepth,
                    const std::string& label) {
    if (width == width_ && height == height_ && formats == formats_ && hasDepth == hasDepth_) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glViewport(0, 0, width, height);
        return;
    }
    framebuffer_ = makeFramebuffer();
    colors_.clear();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());

    // Attach a texture for each output of the fragment shader, and say that all of them are drawn into
    std::vector<GLenum> attachments;
    for (const GLenum format : formats) {
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
        colors_.push_back(texture(format, GL_RGBA, typeOf(format), width, height, label));
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, colors_.back().id(), 0);
    }
    glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    depth_ = TextureObject();
    if (hasDepth) {
        depth_ = texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height, label + " depth");
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    }
    requireComplete("targets " + label);
    labelObject(GL_FRAMEBUFFER, framebuffer_.id(), label);
    glViewport(0, 0, width, height);
    width_ = width;
    height_ = height;
    formats_ = formats;
    hasDepth_ = hasDepth;
}

void Targets::bindColor(std::size_t which, int unit) const { bind(colors_.at(which), unit); }
void Targets::bindDepth(int unit) const { bind(depth_, unit); }

}  // namespace mv
