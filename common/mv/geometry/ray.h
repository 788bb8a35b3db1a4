// Rays in double precision against the simple solids.
#pragma once
#include <optional>

#include "mv/math/types.h"

namespace mv {

// The points origin + t direction, t >= 0. The direction need not have unit length: t counts in its lengths.
struct Ray {
    vec3 origin{0, 0, 0};
    vec3 direction{0, 0, -1};
    vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace mv
