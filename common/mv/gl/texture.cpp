#include "mv/gl/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mv/error.h"
#include "mv/gl/beyond_es.h"

namespace mv {
namespace {

constexpr GLenum maxAnisotropy = 0x84FE,
                 mostAnisotropy = 0x84FF;  // GL_EXT_texture_filter_anisotropic's, and OpenGL 4.6's

void parameter(GLenum name, GLenum value) { glTexParameteri(GL_TEXTURE_2D, name, static_cast<GLint>(value)); }

GLenum formatOf(Texels texels) {
    switch (texels) {
        case Texels::bytes:
            return GL_RGBA8;
        case Texels::srgb:
            return GL_SRGB8_ALPHA8;
        case Texels::halfFloats:
            return GL_RGBA16F;
        case Texels::floats:
            break;
    }
    return GL_RGBA32F;
}

void upload(GLint level, const FloatPicture& picture, Texels texels) {
    const auto format = static_cast<GLint>(formatOf(texels));
    if (texels == Texels::halfFloats || texels == Texels::floats) {
        glTexImage2D(GL_TEXTURE_2D, level, format, picture.width, picture.height, 0, GL_RGBA, GL_FLOAT,
                     picture.values.data());
        return;
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.values.size());
    for (const float value : picture.values)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F))));
    glTexImage2D(GL_TEXTURE_2D, level, format, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 bytes.data());
}

}  // namespace

Texels filteredFloats() { return has(beyond_es::floatFiltering) ? Texels::floats : Texels::halfFloats; }

int largestAnisotropy() {
    if (!hasExtension("GL_EXT_texture_filter_anisotropic") && !hasExtension("GL_ARB_texture_filter_anisotropic"))
        return 1;
    GLint most = 1;
    glGetIntegerv(mostAnisotropy, &most);
    return most;
}

Texture::Texture(const Picture& picture, GLenum filter, const std::string& label)
    : texture_(makeTexture()), width_(picture.width), height_(picture.height) {
    Picture bottomUp = picture;
    flipRows(bottomUp);
    bind(0);
    labelObject(GL_TEXTURE, texture_.id(), label);  // before the upload, which the audit knows by it
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, bottomUp.rgba.data());
    parameter(GL_TEXTURE_MIN_FILTER, filter);
    parameter(GL_TEXTURE_MAG_FILTER, filter);
    parameter(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    parameter(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture::Texture(std::span<const FloatPicture> levels, const TextureOptions& options)
    : texture_(makeTexture()), levels_(static_cast<int>(levels.size())) {
    const std::string& label = options.label;
    if (levels.empty()) throw Error(label, "must have a level at least");
    if (options.driverMipmaps && levels_ > 1)
        throw Error(label, "must have a single level where the driver makes the others", std::to_string(levels_));
    width_ = levels.front().width;
    height_ = levels.front().height;
    bind(0);
    labelObject(GL_TEXTURE, texture_.id(), label);
    for (int level = 0; level < levels_; ++level) {
        const FloatPicture& picture = levels[static_cast<std::size_t>(level)];
        checkPicture(picture, label);
        if (picture.channels != 4) throw Error(label, "must have 4 channels", std::to_string(picture.channels));
        if (picture.width != std::max(1, width_ >> level) || picture.height != std::max(1, height_ >> level)) {
            throw Error(label, "each level must have half the sides of the one before, rounded down, and 1 at least",
                        std::to_string(picture.width) + " x " + std::to_string(picture.height));
        }
        upload(level, picture, options.texels);
    }
    if (options.driverMipmaps) {
        for (int side = std::max(width_, height_); side > 1; side /= 2) ++levels_;
        glGenerateMipmap(GL_TEXTURE_2D);
    }
    parameter(GL_TEXTURE_MAX_LEVEL, static_cast<GLenum>(levels_ - 1));
}

void Texture::filterBy(const TextureFilter& filter, int unit) {
    if (filter.anisotropy < 1 || (filter.anisotropy > 1 && filter.anisotropy > largestAnisotropy())) {
        throw Error("anisotropy", "must be 1 .. " + std::to_string(largestAnisotropy()) + " on this driver",
                    std::to_string(filter.anisotropy));
    }
    bind(unit);
    parameter(GL_TEXTURE_MIN_FILTER, filter.minify);
    parameter(GL_TEXTURE_MAG_FILTER, filter.magnify);
    parameter(GL_TEXTURE_WRAP_S, filter.wrap);
    parameter(GL_TEXTURE_WRAP_T, filter.wrap);
    if (filter.anisotropy != anisotropy_) parameter(maxAnisotropy, static_cast<GLenum>(filter.anisotropy));
    anisotropy_ = filter.anisotropy;
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_.id());
}

}  // namespace mv
