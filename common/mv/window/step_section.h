// The panel's part that stops the frame after one of its draws, and shows what that draw is made of.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mv/host/context.h"
#include "mv/math/types.h"
#include "mv/show/session.h"
#include "mv/show/stage.h"
#include "mv/window/thumbnail.h"

namespace mv {

class StepSection {
  public:
    StepSection(const Context& context, Stage& stage, Session& session)
        : context_(context), stage_(stage), session_(session) {}
    // Once a picture is drawn: finds the pixels of it that its last draw has changed. `width`: of a line round them, in pixels.
    void outline(int width);
    // Lays the line over the picture, whose upper left corner is the window's, so many units wide and high.
    void showOutline(float wide, float high) const;
    // The number of those pixels; none where no frame is stopped after a draw into the picture.
    const std::optional<long>& outlined() const { return outlined_; }
    // `pixel`: that of the picture under the mouse, from its upper left corner. True when the picture is to be drawn anew.
    bool show(const std::optional<glm::ivec2>& pixel);

  private:
    bool showSlider(const FrameSteps& steps);
    void showDraw(const FrameSteps& steps) const;
    void showBuffers(const FrameSteps& steps, std::optional<glm::ivec2> pixel);

    const Context& context_;
    Stage& stage_;
    Session& session_;
    bool begins_ = false;        // the slider comes with the next frame
    long outlinedPicture_ = -1;  // the session's picture that the line is for
    std::optional<long> outlined_;
    std::optional<Thumbnail> line_;
    long picture_ = -1;  // the session's picture that the buffers below are of
    std::vector<Thumbnail> buffers_;
    std::vector<std::array<float, 4>> placed_;  // where they stood in the last frame: left, top, right, bottom
};

}  // namespace mv
