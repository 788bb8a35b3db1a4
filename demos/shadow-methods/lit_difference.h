// Two ways to find a scene's shadows, subtracted: where and how much the lit fractions differ, in false colours.
#pragma once
#include <functional>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/study.h"
#include "mv/geometry/scene.h"
#include "mv/gl/target.h"

namespace mv {

class LitDifference {
  public:
    struct Found {
        double beyondHalf = 0;  // percent of the compared pixels, by more than 0.5
        double rms = 0;
    };
    // Has `draw` and `against` draw the lit fraction as for a study (0..1 in red, -1 where there is none), or without
    // `against` casts a ray from the middle of each pixel and one to scene.lights[0], which is kept while scene and size
    // rest. Fills the frame's picture: red where `draw` is darker, blue where it is lighter, the second way in grey,
    // nearly black where one of them has none. Changes the state that showImage does.
    // Error: the context has no targets of floats (ES 3.0 without EXT_color_buffer_float).
    Found show(const Scene& scene, const Frame& frame, const std::function<void()>& draw,
               const std::function<void()>& against = {});

  private:
    std::vector<float> drawn(const Frame& frame, const std::function<void()>& draw);
    std::vector<float> byRays(const Scene& scene, const FrameInfo& frame);
    Target target_;
    Reference rays_;
    MadeFor<Scene, int, int> castFor_;
};

}  // namespace mv
