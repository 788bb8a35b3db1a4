// A two-dimensional texture made from a picture.
#pragma once
#include <string>

#include "mv/gl/object.h"
#include "mv/image/picture.h"

namespace mv {

class Texture {
  public:
    Texture() = default;
    // RGBA8, edges clamped; `filter` is GL_NEAREST or GL_LINEAR, for both enlarging and reducing. Texture coordinate
    // (0, 0) is the lower left corner, as GL has it: the picture's rows are turned over here.
    explicit Texture(const Picture& picture, GLenum filter = GL_LINEAR, const std::string& label = "texture");
    int width() const { return width_; }
    int height() const { return height_; }
    // Binds it to a texture unit; the shader's sampler is set to the same number.
    void bind(int unit) const;

  private:
    TextureObject texture_;
    int width_ = 0, height_ = 0;
};

}  // namespace mv
