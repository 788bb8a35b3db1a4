// The difference between two eyes' pictures.
#pragma once
#include <optional>
#include <span>

#include "mv/math/types.h"

namespace mv {

// How far the right eye's picture of a point lies from the left eye's, in pixels. Across: positive is to the right,
// which looks farther away than the screen; 0 on the screen; negative before it. Up or down there should be none: eyes
// do not turn apart in height.
struct Parallax {
    double leastAcross, mostAcross;
    double vertical;  // the largest, without its sign
};

// The parallax of these points, in a picture of width x height pixels for each eye. Points that are not before both
// eyes (w < leastW, which is the distance before the eye for a perspective) are passed over; empty where all are.
// Refused: leastW not positive, a size below 1, NaN and infinity.
std::optional<Parallax> parallaxOf(std::span<const vec3> points, const mat4& clipFromLeft, const mat4& clipFromRight,
                                   int width, int height, double leastW);

}  // namespace mv
