// Two knobs that turn what is shown, and the drag that moves them.
#pragma once
#include "mv/demo/demo.h"
#include "mv/math/types.h"

namespace mv {

// A member of a demo. Adds the knobs spin-x and spin-y to it, degrees about these axes, and a drag by `perPixel` degrees: to
// the right about the y axis, downwards about the x axis.
struct Spin {
    explicit Spin(Demo* owner, double initialX = 0, double initialY = 0, const vec2& perPixel = vec2(1));

    // About the y axis first, then about the x axis.
    mat4 turn() const;

    Angle x, y;
};

}  // namespace mv
