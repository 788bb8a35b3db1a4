// The state of OpenGL, as the function table has seen it set: so that it can be put back without asking the driver, and
// without setting what is as it should be.
//
// Kept are the switches, what depth, stencil, blending, masks, clears, culling and polygons are set to, the bindings of
// program, vertex array, buffers and textures, and the layout of pixels in memory. Not kept: framebuffer and viewport,
// which whoever draws sets; the scissor's box, whose initial value is a window's; and what belongs to an object.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace mv {

// Sets what differs from OpenGL's initial state, and returns how many calls that took.
int restoreInitialState();

// glEnable or glDisable, as a setting has it. A switch that is so already is left alone.
void setEnabled(unsigned capability, bool isOn);
// Switches off what is on.
inline void switchOff(unsigned capability) { setEnabled(capability, false); }

// Sets what lies over a picture needs, and of that only what is not so already: blended by alpha, with the alpha of the
// picture by itself, so that an opaque one stays opaque; without culling, polygon offset, stencil and depth test. Or
// with the depth test, which lets equal depths pass and writes none.
enum class Overlay { onTop, hiddenByWhatIsNearer };
void setOverlayState(Overlay overlay = Overlay::onTop);

// The differences from it now, as calls: "glEnable(GL_DEPTH_TEST)", "glDepthFunc".
std::vector<std::string> changedState();

// The same with what it is set to, a draw at a time: "glDepthFunc(GL_LEQUAL)", "glBindTexture(GL_TEXTURE_2D, 'checks') on
// unit 0". Without program and vertex array, buffers, the active unit and the layout of pixels in memory: they say which draw
// it is, or tell the next call of that kind where it goes, and change no pixel of a draw.
std::vector<std::string> stateOfDraw();

// A scope undoes at its end what was set within it: for a helper that draws in the midst of somebody else's picture.
class StateScope {
  public:
    StateScope();
    ~StateScope();
    StateScope(const StateScope&) = delete;
    StateScope& operator=(const StateScope&) = delete;

  private:
    struct Saved;
    std::unique_ptr<Saved> saved_;
};

// For the function table. Lays the keeping over it; and forgets, for another context, which begins in its initial state.
void keepState();
void forgetState();

}  // namespace mv
