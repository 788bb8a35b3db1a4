// How wrong a picture's shadows are, found while it is shown: a coarse grid of its pixels against rays.
#pragma once
#include <functional>
#include <optional>

#include "mv/demo/frame.h"
#include "mv/geometry/scene.h"
#include "mv/gl/target.h"

namespace mv {

struct FalseShadows {
    double dark = 0, lit = 0;  // percent of the pixels: dark though the light reaches them, and the other way round
    long pixels = 0;           // of receivers that face the light, both for the rays and in the picture
};

class ShadowCheck {
  public:
    // Has `draw` draw the lit fraction as for a study (0..1 in red, -1 where there is none) into a target of at most
    // 96 x 96 pixels with depth and stencil, in the shape of the frame, and casts a ray from the middle of each, and one
    // to scene.lights[0]. More than half lit is lit. `draw` finds the state as it was and the target cleared; the state
    // comes back, and the frame's picture is bound. For readouts; a study (--study) measures all pixels. Nothing, and
    // nothing drawn, where the context has no targets of floats (ES 3.0 without EXT_color_buffer_float).
    std::optional<FalseShadows> compare(const Scene& scene, const Frame& frame, const std::function<void()>& draw);

  private:
    Target target_;
};

}  // namespace mv
