// Easing: how far a motion between two keys has come, as a function of how much of its time has passed.
//
// Each function takes t from 0 to 1, refuses others, and has 0 at 0 and 1 at 1 exactly: from + ease(t) (to - from) is at
// the keys at their times. The slope is the velocity, 1 being that of even motion. At t = 1 the slope is that of the end.
#pragma once
#include "mv/math/types.h"

namespace mv {

// t: an even motion, which starts and stops at once. Slope 1.
double linearEase(double t);
double linearEaseSlope(double t);

// The root of t: starts at once and slows down, as a ball that rolls out. Slope 1/(2 sqrt(t)): at 0 it is infinite, which
// is refused.
double rootEase(double t);
double rootEaseSlope(double t);

// t^2: speeds up evenly from rest, as what falls. Slope 2t.
double quadraticEase(double t);
double quadraticEaseSlope(double t);

// The logistic curve 1/(1 + e^(-steepness (t - 1/2))), shifted and scaled to start at 0 and end at 1: speeds up, travels and
// slows down. The trap: the curve itself has 1/(1 + e^(steepness/2)) at 0, 0.7 % for a steepness of 10, and jumps there.
// The slope at 1/2 is steepness/4 over tanh(steepness/4). Refused: a steepness outside 1e-6 to 1e6, the ends being the
// straight line and the jump to 1e-13.
double logisticEase(double t, double steepness);
double logisticEaseSlope(double t, double steepness);

// The cubic Bezier curve from (0, 0) to (1, 1) with two handles, read as a graph: the y at which its x is t. Equals CSS
// cubic-bezier(first.x, first.y, second.x, second.y). Handles' y outside 0 to 1 let it swing beyond its ends.
// The traps: t is not the curve's parameter; and where the graph is vertical (handles (1, y) and (0, y'), at 1/2) y moves
// by the cube root of what t does.
class BezierEase {
  public:
    // Refused: handles whose x is outside 0 to 1, for which x would turn back; y beyond 1e100; NaN.
    BezierEase(const vec2& first, const vec2& second);

    // The parameter is solved for by Newton's method, with bisection where that leaves the bracket, until x(s) is t within
    // its rounding, 4 ulp of t; so the value is off by what 4 ulp of t change, and by 4 ulp of the largest handle's y.
    double value(double t) const;
    // Refused: a t at which the graph is vertical.
    double slope(double t) const;

  private:
    double parameter(double t) const;
    double x(double s) const;
    double y(double s) const;

    vec2 first_, second_;
};

}  // namespace mv
