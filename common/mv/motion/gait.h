// The place of a foot while its body walks: the foot stands still in the world, and then swings to where it stands
// next.
#pragma once
#include "mv/math/types.h"

namespace mv {

// One foot's part in walking along the x axis; the body is at x = stride * cycles.
struct Gait {
    double stride = 1;  // how far the body goes in a cycle, in world units, backwards below 0; the foot's step, too
    double lift = 0.1;  // how high the foot is in the middle of its swing, in world units
    double stance =
        0.6;  // the part of the cycle for which it stands, above 0 and below 1: walking from 1/2 on, else running
    double phase =
        0;  // the part of its cycle that is behind the foot when the body starts; the other foot has 0.5 more
};

struct FootTarget {
    vec2 position{0};  // x along the way and y up, in world space; the floor is y = 0
    bool stands = true;
};

// The foot's target after so many cycles, which need not be whole and may be negative. A cycle begins with the stance:
// its position is then the same to the bit, so that a foot under inverse kinematics does not slide; the body passes
// over it in its middle. Swing: x by 10s^3 - 15s^4 + 6s^5 and y by 64 s^3(1-s)^3, whose velocities and accelerations
// are 0 at both ends, so that the foot neither drags nor bumps. Refused: a stance outside (0, 1), stride and lift
// beyond 1e100, cycles and phase beyond 1e12, NaN, infinity. Trap: joint angles that are interpolated between poses
// with the foot on the floor move it.
FootTarget footTarget(const Gait& gait, double cycles);

}  // namespace mv
