// The reflectance of a surface over the angle, as curves in a picture.
#pragma once
#include "mv/gl/drawing.h"
#include "shared/fresnel.h"

namespace mv {

// Axes, and of the coating a curve over the angle from the normal, or one each for red, green and blue where they differ;
// thin lines are Schlick's. The box is in pixels of the picture.
void drawReflectance(Drawing& drawing, const Box& box, const Coating& coating);

}  // namespace mv
