// A floor to the horizon and its patterns, made by formulas, so that demo, study and tests have the same.
#pragma once
#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

enum class FloorPattern { checker, stripes, bricks };

// One repeat of it in size x size texels of linear light, four channels, the lower row first as textures have it. Each
// texel is the mean of 4 x 4 points of the pattern, so that an odd size has grey texels at its edges. Bricks have one of
// some shades each, scattered by a fixed seed.
FloatPicture floorPattern(FloorPattern pattern, int size);

// The part of the light that the eye counts as brightness: Rec. 709's weights of linear red, green and blue.
double luminance(const float* texel);

// The camera above the floor y = 0: at a height of 1, tilted down.
struct FloorCamera {
    mat4 viewFromWorld, clipFromView;
};
FloorCamera floorCamera(double aspect);

// Repeats of the texture, as (u, v, 1) up to a factor, from places in a picture in pixels from its lower left corner,
// (x, y, 1). The third is above 0 below the horizon. `turn`: of the pattern, in degrees.
mat3 repeatsFromPixel(int width, int height, double turn);

// The place of a pixel on the floor, and how it moves with the pixel, in repeats.
struct Footprint {
    vec2 middle, acrossX, acrossY;
};
Footprint footprintOf(const mat3& repeatsFromPixel, const vec2& pixel);

}  // namespace mv
