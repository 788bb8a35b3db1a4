// Figures of surfaces that are lit and looked at from a side: the angle of sight, and the lamp's direction. With words of that height, or with
// none where it is 0.
#pragma once
#include <vector>

#include "mv/gl/drawing.h"

namespace mv {

// A surface, its normal, and the way to the eye at an angle in degrees, all `size` pixels long, with its foot at `foot`.
struct SightFigure {
    vec2 foot;
    double size;
    // The end of the way to the eye.
    vec2 tip(double degrees) const;
    void draw(Drawing& drawing, double degrees, int wordHeight) const;
};

// The lamp's direction as seen along the surface's normal: in the middle it shines straight down.
struct LampDial {
    vec2 middle;
    double radius;
    // The mark of the unit vector to the lamp.
    vec2 at(const vec3& towardsLamp) const { return middle + radius * vec2(towardsLamp); }
    void draw(Drawing& drawing, const vec3& towardsLamp, int wordHeight) const;
};

// The colours of the levels of tessellation 1, 2, 4, ... 64, linear; and what they mean, along the right edge of the picture.
const std::vector<vec3>& levelColors();
void drawLevelColors(Drawing& drawing, const FrameInfo& frame, int wordHeight);

}  // namespace mv
