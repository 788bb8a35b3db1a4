// The order of things as a depth buffer keeps it: a model in the arithmetic of a GPU, without a GPU.
#pragma once
#include <functional>
#include <vector>

#include "mv/math/types.h"

namespace mv {

enum class DepthFormat { d16, d24, d32f };

// The depth 0..1 of a point `distance` in front of the eye, computed in float: z by the matrix, divided by w, which is the
// distance, and taken to the depth range 0..1. `zeroToOne`: z/w is in 0..1 already, as with glClipControl.
float windowDepth(const fmat4& clipFromView, float distance, bool zeroToOne);

// The depth that a buffer of this format keeps: cut to 0..1, and in 16 or 24 bits rounded to the nearest step.
double keptDepth(DepthFormat format, float depth);

// Judges `count` pairs of points, one at z and one at z (1 + separation), in equal ratios between near and far: 1 for
// each that `depthOf` gives equal depths or a larger one for the nearer, 0 for the rest. Refused: near not above 0, far
// not above near (1 + separation), a negative separation, a count below 1.
std::vector<double> misorderedPairs(double near, double far, double separation, int count,
                                    const std::function<double(float distance)>& depthOf);

}  // namespace mv
