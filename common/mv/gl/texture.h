// A two-dimensional texture made from a picture, or from a picture and its mipmaps.
#pragma once
#include <span>
#include <string>

#include "mv/gl/object.h"
#include "mv/image/picture.h"

namespace mv {

// How a texture is looked up between its texels.
struct TextureFilter {
    GLenum minify = GL_LINEAR;   // GL_NEAREST, or with levels GL_LINEAR_MIPMAP_LINEAR
    GLenum magnify = GL_LINEAR;  // or GL_NEAREST
    GLenum wrap = GL_CLAMP_TO_EDGE;
    int anisotropy = 1;  // looks along the longer axis of a pixel, up to largestAnisotropy()
};

// The format of a texel. The shader reads linear light from `srgb`. ES 3.0 filters `floats` only with
// OES_texture_float_linear: filteredFloats() asks for it.
enum class Texels { bytes, srgb, halfFloats, floats };

// Floats that the driver filters: `floats`, or `halfFloats` where it has no beyond_es::floatFiltering, as has() then
// notes.
Texels filteredFloats();

struct TextureOptions {
    Texels texels = Texels::bytes;
    bool driverMipmaps =
        false;  // glGenerateMipmap makes the levels below the first. Trap: odd sides are its own affair
    std::string label = "texture";
};

// The driver's most, of GL_EXT_texture_filter_anisotropic or OpenGL 4.6; 1 where it has neither.
int largestAnisotropy();

class Texture {
  public:
    Texture() = default;
    // RGBA8, edges clamped; `filter` is GL_NEAREST or GL_LINEAR, for both enlarging and reducing. Texture coordinate
    // (0, 0) is the lower left corner, as GL has it: the picture's rows are turned over here.
    explicit Texture(const Picture& picture, GLenum filter = GL_LINEAR, const std::string& label = "texture");
    // A texture of four floats a texel, 0..1 for bytes, the lower row FIRST here, as GL has it: they are uploaded as
    // they are, also for Texels::srgb, which is given what is kept. One level, or more of them (mipmaps() in
    // mv/image/mipmap.h), each half of the one before. The texture is bound, and filterBy() is still to say how it is
    // looked up. Error: other channels or sizes; more than one level and driverMipmaps.
    Texture(std::span<const FloatPicture> levels, const TextureOptions& options);

    // Binds it to that unit and sets how it is looked up. Error: an anisotropy that is not in 1..largestAnisotropy().
    void filterBy(const TextureFilter& filter, int unit = 0);

    int width() const { return width_; }
    int height() const { return height_; }
    int levels() const { return levels_; }
    // Binds it to a texture unit; the shader's sampler is set to the same number.
    void bind(int unit) const;

  private:
    TextureObject texture_;
    int width_ = 0, height_ = 0, levels_ = 1, anisotropy_ = 1;
};

}  // namespace mv
