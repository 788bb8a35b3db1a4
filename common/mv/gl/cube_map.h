// A texture of six faces that is looked up by a direction: of pictures, or drawn from a scene.
#pragma once
#include <array>
#include <string>

#include "mv/geometry/cube_faces.h"
#include "mv/gl/object.h"
#include "mv/image/picture.h"

namespace mv {

// Looked up bilinearly, without mipmaps. Faces are clamped to their edges, so that at the cube's own edges a seam shows
// unless GL_TEXTURE_CUBE_MAP_SEAMLESS is on, a switch of all cube maps that is off in OpenGL; ES 3.0 has none, and none of
// the seams.
class CubeMap {
  public:
    CubeMap() = default;
    // A cube map to be drawn into: size x size pixels a face, 8 bits a channel, and one depth buffer for whichever face
    // is drawn. Error: a size that the driver cannot make.
    explicit CubeMap(int size, const std::string& label = "cube map");
    // A cube map of six squares of one size, of four floats a texel, in the order and orientation of
    // mv/geometry/cube_faces.h: the row of t = 0 first. Kept in 8 bits a channel. Error: other sizes or channels.
    explicit CubeMap(const std::array<FloatPicture, cubeFaces>& faces, const std::string& label = "cube map");

    int size() const { return size_; }
    // Draws go into this face from now on; frame.bindTarget() ends that. The viewport, one for all faces, is the caller's:
    // glViewport(0, 0, size, size). Trap: the depth buffer holds what the face before left. Error: a face outside 0..5; made
    // of pictures.
    void bindForDrawing(int face) const;
    // Binds it to a texture unit; the shader's samplerCube is set to the same number.
    void bind(int unit) const;

  private:
    void make(int size, const std::string& label);

    int size_ = 0;
    TextureObject texture_;
    Renderbuffer depth_;
    std::array<Framebuffer, cubeFaces> framebuffers_;
};

}  // namespace mv
