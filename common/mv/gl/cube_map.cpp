#include "mv/gl/cube_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "mv/error.h"
#include "mv/gl/state.h"
#include "mv/gl/target.h"

namespace mv {
namespace {

GLenum target(int face) { return GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face); }

void store(int face, int size, const void* texels) {
    glTexImage2D(target(face), 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
}

}  // namespace

// The texture alone, bound.
void CubeMap::make(int size, const std::string& label) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    if (size < 1 || size > largest) {
        throw Error(label, "must have 1 .. " + std::to_string(largest) + " texels a side on this driver",
                    std::to_string(size));
    }
    size_ = size;
    texture_ = makeTexture();
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture_.id());
    labelObject(GL_TEXTURE, texture_.id(), label);
    const auto set = [](GLenum name, GLenum value) {
        glTexParameteri(GL_TEXTURE_CUBE_MAP, name, static_cast<GLint>(value));
    };
    set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum wrap : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        set(wrap, GL_CLAMP_TO_EDGE);
}

CubeMap::CubeMap(int size, const std::string& label) {
    const StateScope scope;
    make(size, label);
    for (int face = 0; face < cubeFaces; ++face) store(face, size, nullptr);
    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    depth_ = makeRenderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size, size);
    for (int face = 0; face < cubeFaces; ++face) {
        Framebuffer& framebuffer = framebuffers_.at(static_cast<std::size_t>(face));
        framebuffer = makeFramebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target(face), texture_.id(), 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
        labelObject(GL_FRAMEBUFFER, framebuffer.id(), label + " face " + std::to_string(face));
        requireComplete(label);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
}

CubeMap::CubeMap(const std::array<FloatPicture, cubeFaces>& faces, const std::string& label) {
    for (const FloatPicture& face : faces) {
        checkPicture(face, label);
        if (face.channels != 4) throw Error(label, "must have 4 channels", std::to_string(face.channels));
        if (face.width != face.height || face.width != faces.front().width) {
            throw Error(label, "must have six squares of one size",
                        std::to_string(face.width) + " x " + std::to_string(face.height));
        }
    }
    const StateScope scope;
    make(faces.front().width, label);
    for (int face = 0; face < cubeFaces; ++face) {
        const std::vector<float>& values = faces.at(static_cast<std::size_t>(face)).values;
        std::vector<std::uint8_t> bytes;
        bytes.reserve(values.size());
        for (const float value : values)
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F))));
        store(face, size_, bytes.data());
    }
}

void CubeMap::bindForDrawing(int face) const {
    if (face < 0 || face >= cubeFaces) throw Error("cube face", "must be 0 .. 5", std::to_string(face));
    const Framebuffer& framebuffer = framebuffers_.at(static_cast<std::size_t>(face));
    if (!framebuffer) throw Error("cube map", "must be made to be drawn into, not of pictures");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
}

void CubeMap::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture_.id());
}

}  // namespace mv
