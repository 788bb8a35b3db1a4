// A camera whose picture may be narrow.
#pragma once
#include <cmath>

#include "mv/math/transform.h"

namespace mv {

// The vertical angle of view, degrees, with which a picture of that aspect (width by height) shows as much across as one of the
// aspect `least` does with `fovy`: fovy itself, unless the picture is narrower.
inline double fovyAcross(double fovy, double aspect, double least = 1) {
    if (aspect >= least) return fovy;
    return 2 * degrees(std::atan(std::tan(radians(fovy / 2)) * least / aspect));
}

}  // namespace mv
