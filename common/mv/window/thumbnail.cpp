#include "mv/window/thumbnail.h"

#include <cstdint>
#include <utility>

#include "mv/gl/functions.h"

namespace mv {

Thumbnail::Thumbnail(const Context& context, const Picture& picture) : width_(picture.width), height_(picture.height) {
    const auto generate = reinterpret_cast<PFNGLGENTEXTURESPROC>(context.address("glGenTextures"));
    delete_ = reinterpret_cast<Delete>(context.address("glDeleteTextures"));
    generate(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    // Dear ImGui counts rows from the top, as the picture does.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

Thumbnail::~Thumbnail() {
    if (texture_ != 0) delete_(1, &texture_);
}

Thumbnail::Thumbnail(Thumbnail&& other) noexcept
    : texture_(std::exchange(other.texture_, 0)),
      width_(other.width_),
      height_(other.height_),
      delete_(other.delete_) {}

Thumbnail& Thumbnail::operator=(Thumbnail&& other) noexcept {
    std::swap(texture_, other.texture_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(delete_, other.delete_);
    return *this;
}

void* Thumbnail::imguiId() const {
    // ImGui carries the texture's number in a pointer that nobody follows.
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(texture_));  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace mv
