// How long a curve in space is, and when it has come how far: what moves along it at equal speed needs this, since equal
// steps of time are not equal steps of way.
#pragma once
#include <vector>

#include "mv/motion/curve.h"

namespace mv {

// A curve's length in the unit of its keys, and its time at each part of it. Lengths count from the start of the curve, up
// to the end of one round of a closed one: take std::fmod of a longer way.
//
// Lengths are within tolerance times length() of the truth, cusps and rests included: adaptive Gauss-Legendre integration
// of the speed, from break to break, halved where two halves say other than the whole. The truth is that of the curve as
// Curve::at computes it, whose own roundings are about 1e-15 of the keys' size.
class ArcLength {
  public:
    // Computes the table that is looked up later: some microseconds for each span of a smooth curve.
    // Refused: a tolerance outside 1e-13..0.1; and what Curve::at refuses.
    explicit ArcLength(Curve<vec3> curve, double tolerance = 1e-12);

    double length() const { return leaves_.back().after; }

    // The way from the start to this time; it never falls. 10 evaluations of the curve. Refused: a time outside the curve's
    // start..end.
    double lengthAt(double time) const;

    // The first time at which the way is this long: lengthAt of it is `way` within 1e-14 of way, or as near as neighbouring
    // times allow. Later ways have later times, as far as this accuracy can tell them. The trap: where the curve rests,
    // times are passed over, so the last one may be before end(). Newton's method with bisection as a safeguard (at a cusp
    // the speed is 0), about 40 evaluations.
    // Refused: a way that is not 0..length().
    double timeAt(double way) const;

  private:
    // A part of the curve that was not halved further.
    struct Leaf {
        double start, end;     // times
        double before, after;  // the way at both
    };

    double integral(double from, double to) const;
    void add(double from, double to, double whole, double allowed);
    double partOf(const Leaf& leaf, double time) const;

    Curve<vec3> curve_;
    double tolerance_;
    std::vector<Leaf> leaves_;
};

// The plain forms, without any estimate of their errors, for comparison.
//
// The length of the line through count + 1 points at equal steps of time: never too long but for rounding; error O(1/n^2).
// Refused: count outside 1..1e7.
double arcLengthByChords(const Curve<vec3>& curve, int count);
// Simpson's rule on the speed at count + 1 equally spaced times: error O(1/n^4) for a smooth curve; O(1/n^2) where the
// acceleration jumps within a step. Refused: a count outside 2..1e7, or odd.
double arcLengthBySimpson(const Curve<vec3>& curve, int count);
// The Gauss-Legendre rule with so many nodes in each span from break to break: the error falls exponentially, but at cusps.
// Refused: count outside 1..64.
double arcLengthByGauss(const Curve<vec3>& curve, int count);

}  // namespace mv
