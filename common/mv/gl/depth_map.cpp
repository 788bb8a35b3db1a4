#include "mv/gl/depth_map.h"

#include "mv/error.h"
#include "mv/gl/state.h"
#include "mv/gl/target.h"

namespace mv {

DepthMap::DepthMap(int size, const std::string& label) : DepthMap(size, label, nullptr) {}

DepthMap::DepthMap(int size, const std::string& label, const void* depths) : size_(size) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (size < 1 || size > largest) {
        throw Error(label, "must have 1 .. " + std::to_string(largest) + " texels a side on this driver",
                    std::to_string(size));
    }
    const StateScope scope;
    texture_ = makeTexture();
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    labelObject(GL_TEXTURE, texture_.id(), label);

    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    framebuffer_ = makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_.id(), 0);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
    requireComplete(label);
    labelObject(GL_FRAMEBUFFER, framebuffer_.id(), label);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
}

void DepthMap::bindForDrawing() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, size_, size_);
}

void DepthMap::begin(int size, const std::string& label) {
    if (size != size_) *this = DepthMap(size, label);
    bindForDrawing();
}

void DepthMap::bind(int unit, DepthLookup lookup) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    const bool compares = lookup != DepthLookup::depth;
    const GLint filter = lookup == DepthLookup::compareLinear ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, compares ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

}  // namespace mv
