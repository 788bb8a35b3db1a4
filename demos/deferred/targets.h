// Several textures that one pass draws into.
#pragma once
#include <string>
#include <vector>

#include "mv/gl/object.h"

namespace mv {

class Targets {
  public:
    // Makes textures of this size and of these formats anew, unless they are so already: GL_RGBA8, GL_RGB10_A2 or GL_RGBA16F; and
    // where it has a depth, GL_DEPTH_COMPONENT24. Draws go into all of them from now on, by the locations of the fragment shader's
    // outputs, and the viewport covers them. Error: what the driver refuses.
    void begin(int width, int height, const std::vector<GLenum>& formats, bool hasDepth, const std::string& label);
    // Binds the texture of that place among the formats to a unit; and the depths.
    void bindColor(std::size_t which, int unit) const;
    void bindDepth(int unit) const;

  private:
    int width_ = 0, height_ = 0;
    std::vector<GLenum> formats_;
    bool hasDepth_ = false;
    Framebuffer framebuffer_;
    std::vector<TextureObject> colors_;
    TextureObject depth_;
};

}  // namespace mv
