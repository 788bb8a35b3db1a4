// The light of lamps as numbers: falloff with the distance, and a cone's edge.
#pragma once
#include "mv/math/types.h"

namespace mv {

// A lamp's light at a distance, relative to its power: 1 / (constant + linear d + quadratic d^2). The lamp is a ball of
// this radius: nearer than its surface there is no more light than at it, so it is finite at d = 0, and nowhere rises.
// Outside, a ball that shines evenly gives exactly what a point in its middle gives to a surface that sees all of it.
struct Falloff {
    double constant = 0, linear = 0, quadratic = 1;
    double size = 0.05;

    // Refused: a distance below 0 or not finite, terms or a size below 0 or not finite, and a sum of 0.
    double at(double distance) const;
    // The distance from which on `power` times it is not above `threshold`; infinity where it never falls so far (a
    // threshold of 0, or a constant alone).
    double reach(double power, double threshold) const;
};

// The part of a spot's light at an angle from its axis, by cosines: 1 within the inner cone, 0 outside of the outer one,
// and between them 3t^2 - 2t^3 of t, which goes from 0 to 1 with the cosine. The edge is a step where both cones are
// one. Refused: an inner cosine below the outer one, NaN.
double spotEdge(double cosine, double innerCosine, double outerCosine);

}  // namespace mv
