// Two legs that walk along the x axis, for lessons: the places that hip and feet must have, and angles that are played.
#pragma once
#include <vector>

#include "mv/math/types.h"
#include "mv/motion/gait.h"

namespace mv {

// The walk of legs as in jointed.h, whose lengths are above 0. Side 0 is the near leg; time is in cycles, and the floor
// is y = 0.
struct Walk {
    double upper, lower;
    int poses;  // of a cycle, above 0

    // 0.88 of the leg's length above the floor, and 0.9 of it further with each cycle.
    vec2 hip(double cycles) const;
    FootTarget foot(int side, double cycles) const;

    // The angles of the five joints of legs(): at each of the poses those at which the feet are where they have to be, and
    // between two poses angles that go evenly, the shorter way round, from one to the other. Degrees.
    std::vector<double> played(double cycles) const;
};

}  // namespace mv
