// A scene on a turntable: three knobs to look at it from all sides, and how the pointer moves them.
#pragma once
#include "mv/demo/demo.h"
#include "mv/math/types.h"
#include "shared/spin.h"

namespace mv {

// A member of a demo. Adds the knobs spin-x, spin-y and distance to it, a drag that turns by a degree for each pixel,
// and a wheel that steps forward by a quarter for each notch.
struct Turntable {
    // `steps`: how far the distance goes, 0 where the camera stands.
    Turntable(Demo* owner, Real::Range steps);

    // World space turned about its origin: about the y axis first, then about the x axis.
    mat4 turn() const;
    // The camera's view of the world turned so, from `distance` further back along the gaze.
    mat4 seenBy(const mat4& viewFromWorld) const;

    Spin spin;
    Real distance;
};

}  // namespace mv
