// The draws of a frame, one by one: what each is made of; and a frame that is stopped after one of them.
//
// A draw is a glDrawArrays or glDrawElements of the frame. One with GL_RASTERIZER_DISCARD makes no picture (it counts
// triangles, say): it is no step, and never left out. A frame that is stopped after its K-th draw leaves out, from then on,
// each draw, glClear, glClearBufferfv and glBlitFramebuffer, and nothing else: what is read back then is what the buffers
// hold, and a query counts nothing. Stopped after 0 draws it leaves out the first draw and what follows, and so makes the
// clears before it.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "mv/gl/functions.h"
#include "mv/image/picture.h"

namespace mv {

struct DrawStep {
    std::string mesh;       // the label of its vertex array: "'cube'"; without one "unnamed 3"
    std::string program;    // "'shadow-map.depth'"
    std::string primitive;  // "GL_TRIANGLES"
    int count = 0;          // of vertices, or of indices
    bool indexed = false;
    std::string target;         // the label of its framebuffer
    int width = 0, height = 0;  // of that
    bool inPicture = true;      // it is the frame's picture, not a target of the demo's own
    // The part of OpenGL's state that differs from the initial one, see stateOfDraw(); the viewport where it is not the
    // whole target, and the scissor's box where it cuts.
    std::vector<std::string> state;
    bool operator==(const DrawStep&) const = default;
};

// A buffer made visible.
struct BufferPicture {
    std::string name;   // "color", "depth" or "stencil"
    std::string range;  // what its shades stand for: "0.25 is black, 1 white"; or why there is no picture
    Picture picture;    // none where it cannot be read
    // Where the shades are not the values: these, the lowest row first, and so many for a pixel; of four the last is alpha.
    std::vector<float> values = {};
    int channels = 0;
};

// What such a buffer has in that pixel, from its upper left corner: "255 0 128", "0.9731". "" beyond it, or of no picture.
std::string valueAt(const BufferPicture& buffer, int x, int y);

// The framebuffer of the last draw that was made (of none: the picture's), as it was just then.
struct TargetPictures {
    std::string target;
    int width = 0, height = 0;
    bool isPicture = true;
    std::vector<BufferPicture> buffers;  // those that it has
};

// While one lives it hears all calls of the demo: it is to live before what the demo draws into is made. One at a time, and
// not beside the audit.
class StepWatch {
  public:
    StepWatch();
    ~StepWatch();
    StepWatch(const StepWatch&) = delete;
    StepWatch& operator=(const StepWatch&) = delete;

    // The frame begins; the framebuffer that is bound is the picture's. The frame is stopped after so many draws; one with
    // fewer is whole.
    void begin(int stopAfter);
    void end();

    const std::vector<DrawStep>& draws() const;  // of the whole frame, those that were left out, too
    const TargetPictures& shown() const;         // where it was stopped

  private:
    class Listener;
    std::unique_ptr<Listener> listener_;
};

}  // namespace mv
