// Two links in a plane, as an arm with shoulder and elbow or a leg with hip and knee: forward, and back in closed form.
//
// The shoulder is the origin. The first link leaves it at `shoulder` degrees from the x axis, counter-clockwise; the
// second one goes on from its end, turned by `elbow` degrees more, so that 0 is a straight arm.
#pragma once
#include <array>
#include <string_view>

#include "mv/math/types.h"

namespace mv {

struct TwoLinkAngles {
    double shoulder = 0, elbow = 0;  // degrees
};

// The end of the second link: (l1 cos a + l2 cos(a+b), l1 sin a + l2 sin(a+b)) for the angles a and b. Any finite
// angles; lengths 0 to 1e300, in the unit of the result. Refused: another length, NaN, infinity.
vec2 twoLinkEnd(double l1, double l2, const TwoLinkAngles& angles);

enum class TwoLinkSolutions { none, one, two, infinitelyMany };

struct TwoLinkAnswer {
    TwoLinkSolutions solutions = TwoLinkSolutions::none;
    std::string_view reason;  // why there are so many, for a reader
    // Two, where there are two: the elbow turned counter-clockwise (above 0), then clockwise. Seen along the way from
    // shoulder to target it then lies on the right, and on the left: which one is "up" depends on where the target is.
    // Else the same angles twice: of infinitely many one, with 0 for what is free; of none those that bring the end as
    // near as can be. All are within -180..180 degrees.
    std::array<TwoLinkAngles, 2> angles;
    double distance = 0;  // from the target to the nearest point that the end reaches; 0 where there are solutions
};

// The angles at which the end is at the target. Lengths 0 to 1e300, and a target within 1e300. Refused: another length
// or target, NaN, infinity. None: the target is farther than l1 + l2, or nearer than |l1 - l2|. One: it is at one of
// these two distances, told exactly of |target| as a double: a target that was rounded itself, (cos, sin) times the
// reach say, is beside it by chance. Infinitely many: equal links and the target at the shoulder; a link of length 0
// and the target at the other one's end. A target at the shoulder that cannot be reached is answered along the x axis.
// The law of cosines as tan of half the angle, from the differences of the lengths: the end is within some roundings of
// l1 + l2 of the target, at a straight and at a folded arm, too, where acos loses half of the digits, and then returns
// NaN. Source: Kahan, "Miscalculating area and angles of a needle-like triangle" (1986, 2014). Trap: the angles of
// targets as near as you like jump, by half a turn of the shoulder at the root.
TwoLinkAnswer twoLinkAngles(double l1, double l2, const vec2& target);

}  // namespace mv
