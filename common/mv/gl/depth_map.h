// A depth texture that is drawn into from a light and looked up from the eye: the map of a shadow.
#pragma once
#include <string>

#include "mv/gl/object.h"

namespace mv {

// How a shader reads the map.
enum class DepthLookup {
    depth,           // sampler2D: the depth 0..1 of the nearest texel
    compareNearest,  // sampler2DShadow: 1 where the third coordinate is at most the nearest texel's depth, else 0
    compareLinear,   // sampler2DShadow: that answer of the 2x2 texels around, weighted by distance
};

class DepthMap {
  public:
    DepthMap() = default;
    // size x size texels of 24 bits, edges clamped: whether a point is on the map at all is for the shader to ask (OpenGL
    // ES has no border). Error: a size the driver cannot make.
    explicit DepthMap(int size, const std::string& label = "depth map");
    // One texel at the greatest depth, for a shader whose shadow sampler asks nothing in this draw: OpenGL leaves undefined what a
    // draw does whose shadow sampler has no depth texture, asked or not.
    static DepthMap empty(const std::string& label = "empty depth map") { return DepthMap(1, label, &farthest); }
    int size() const { return size_; }
    // Draws go here from now on, the viewport covering all of it; frame.bindTarget() ends that.
    void bindForDrawing() const;
    // Binds it for drawing, and makes it anew before where it has another size. Error: as the constructor.
    void begin(int size, const std::string& label = "depth map");
    // Binds it to a texture unit for reading; the shader's sampler is set to the same number.
    void bind(int unit, DepthLookup lookup) const;

  private:
    static constexpr unsigned farthest = ~0U;
    DepthMap(int size, const std::string& label, const void* depths);

    int size_ = 0;
    TextureObject texture_;
    Framebuffer framebuffer_;
};

}  // namespace mv
