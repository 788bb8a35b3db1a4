// The framebuffer a picture is drawn into: exactly the buffers that were asked for.
#pragma once
#include <string>
#include <vector>

#include "mv/gl/object.h"
#include "mv/image/picture.h"

namespace mv {

// Whether this context draws into colours of floats (GL_R32F): OpenGL does, ES 3.0 where it has EXT_color_buffer_float.
bool floatTargets();
// Whether it also blends into those of 32 bits: ES 3.0 where it has EXT_float_blend.
bool floatBlending();

// The longest side of a target that this driver makes, in pixels.
int largestTargetSide();
// Error: the framebuffer that is bound (GL_FRAMEBUFFER) lacks something for drawing into it; `subject` begins its sentence.
void requireComplete(const std::string& subject);

// Every host draws into one of these and never into its window: only then are the bytes the same on OSMesa, EGL and in
// a window.
class Target {
  public:
    struct Buffers {
        bool depth = false;
        bool stencil = false;
        int samples = 0;
        GLenum color = GL_RGBA8;                    // or GL_R32F, for a quantity instead of a picture
        bool texture = false;                       // the colours can be read by a later draw: bindColor()
        GLenum depthFormat = GL_DEPTH_COMPONENT24;  // or GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT32F; without stencil
        bool depthTexture = false;                  // the depths can be read by a later draw: bindDepth()
        bool operator==(const Buffers&) const = default;
    };
    Target() = default;
    // Error: a size the driver cannot make, a number of samples it does not have.
    Target(int width, int height, Buffers buffers, const std::string& label = "target");

    int width() const { return width_; }
    int height() const { return height_; }
    const Buffers& buffers() const { return buffers_; }

    // Makes it anew, as the constructor does, unless it has this size and these buffers already. True where it was
    // made: then nothing is drawn in it yet, and it is the one that is bound.
    bool fit(int width, int height, const Buffers& buffers, const std::string& label = "target");

    // Draws go here from now on, the viewport covering all of it.
    void bind() const;
    // Fits it and binds it, whether it was made anew or not.
    void begin(int width, int height, const Buffers& buffers, const std::string& label = "target");
    // Binds the colours to a texture unit, for a target made with Buffers::texture; a shader reads them with texelFetch or
    // texture() (nearest texel, edges clamped). Error: made without. Trap: not while draws go into this same target.
    void bindColor(int unit) const;
    // The same for the depths, 0..1 in red, for a target made with Buffers::depthTexture.
    void bindDepth(int unit) const;
    // Binds the colours to an image unit, for a compute shader that writes them as rgba8; of a target made with
    // Buffers::texture and GL_RGBA8. Equals glBindImageTexture. Error: made otherwise. Trap: what is written is read by a
    // later draw only after glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT).
    void bindImage(int unit) const;
    // The colours as a picture, samples resolved. Leaves the target bound.
    Picture read() const;
    // The same of a target without samples that is bound, as it is after draws into it.
    Picture readBound() const;
    // Red as numbers, those of 8 bits from 0 to 1, the upper row first, for a target without samples. Leaves the target
    // bound.
    std::vector<float> readRed() const;
    // Copies the colours to the window's framebuffer with the lower left corner at (x, y), and leaves that bound.
    void blitToWindow(int x, int y) const;

  private:
    GLuint resolved() const;  // the framebuffer to read from
    int width_ = 0, height_ = 0;
    Buffers buffers_;
    Framebuffer framebuffer_, single_;
    Renderbuffer color_, depthStencil_, singleColor_;
    TextureObject colorTexture_, depthTexture_;  // instead of color_ and of depthStencil_
};

}  // namespace mv
