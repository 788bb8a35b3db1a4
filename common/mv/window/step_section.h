// The panel's part that stops the frame after one of its draws, and shows what that draw is made of.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mv/host/context.h"
#include "mv/math/types.h"
#include "mv/show/session.h"
#include "mv/window/thumbnail.h"

namespace mv {

class StepSection {
  public:
    StepSection(const Context& context, Session& session) : context_(context), session_(session) {}
    // `pixel`: that of the picture under the mouse, from its upper left corner. True when the picture is to be drawn anew.
    bool show(const std::optional<glm::ivec2>& pixel);

  private:
    bool showSlider(const FrameSteps& steps);
    void showDraw(const FrameSteps& steps) const;
    void showBuffers(const FrameSteps& steps, std::optional<glm::ivec2> pixel);

    const Context& context_;
    Session& session_;
    long picture_ = -1;  // the session's picture that the buffers below are of
    std::vector<Thumbnail> buffers_;
    std::vector<std::array<float, 4>> placed_;  // where they stood in the last frame: left, top, right, bottom
};

}  // namespace mv
