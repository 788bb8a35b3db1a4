// A quantity drawn as for a study, in the midst of a frame.
#pragma once
#include <functional>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/gl/target.h"

namespace mv {

// Clears the target to -1, where nothing is compared, with all its buffers, has `draw` draw the quantity into it in red,
// and returns that, one float a pixel, the upper row first. `draw` finds the state as the caller has it; what it changes is
// undone, and the frame's picture is bound again. The target has one float a pixel (R32F).
std::vector<float> drawMeasured(const Target& target, const Frame& frame, const std::function<void()>& draw);

}  // namespace mv
