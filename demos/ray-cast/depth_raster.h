// Triangles filled into a depth buffer by the processor, as a graphics card does it: one triangle after the other, each in
// the pixels that it covers.
#pragma once
#include <span>
#include <vector>

#include "mv/geometry/bvh.h"

namespace mv {

struct DepthRaster {
    // One entry a pixel, the upper row first: the depth -1..1 after the division, 1 where there is nothing; and the triangle's
    // index, -1 where there is none.
    std::vector<double> depth;
    std::vector<int> triangle;
};

// Which pixels a triangle covers is decided in whole numbers, at their middles. Depths are linear in the picture. Triangles that
// reach before the near plane are not supported. Refused: a corner that is not before the eye.
DepthRaster rasterized(std::span<const SceneTriangle> triangles, const mat4& clipFromWorld, int width, int height);

}  // namespace mv
