// How a scene is turned and stepped back from, to look at it from all sides.
#pragma once
#include "mv/math/types.h"

namespace mv {

// A member of a lesson's settings; shared/orbit_rows.h has the rows.
struct Orbit {
    double spinX = 0, spinY = 0;  // degrees
    double distance = 0;          // steps back, 0 where the camera stands
};

// World space turned about its origin: about the y axis first, then about the x axis.
mat4 turnOf(const Orbit& orbit);
// The camera's view of the world turned so, from `distance` further back along the gaze.
mat4 seenFrom(const Orbit& orbit, const mat4& viewFromWorld);

}  // namespace mv
