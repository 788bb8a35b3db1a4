// Curves through or near keys: a value, or a place in space, that changes with time.
//
// Times are in any unit, and velocities are per that unit. P is double (a property of an object) or vec3 (its place, in
// whatever space the keys are in). The curves are all affinely invariant: keys that are moved, turned or scaled move, turn
// or scale the curve.
#pragma once
#include <memory>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// The value at a time.
template <typename P>
struct Keyframe {
    double time;
    P value;
};

// A curve at a time: its first and second derivative by time stand beside the position.
template <typename P>
struct CurvePoint {
    P position, velocity, acceleration;
};

// A closed curve begins again at its end. Its last key says when: it must have the first key's value.
enum class Ends { open, closed };

// The parameter in which a Catmull-Rom curve takes its tangents; see there.
enum class Knots { uniform, centripetal, times };

// A curve is made once, by the function that is named like its kind; copies share what was computed then.
//
// Each kind refuses: no keys, times that do not increase from key to key (so no time twice), NaN, infinity, keys so large
// or so close in time that a derivative overflows, and a closed curve whose last key differs from the first. One key is a
// constant, at any time. Two keys of an open curve are a straight line, where nothing else is said. Equal values one after
// the other are no error for any kind.
//
// A curve that passes through its keys has exactly their values at their times.
template <typename P>
class Curve {
  public:
    using Keys = std::vector<Keyframe<P>>;

    // Straight from key to key at constant velocity, which jumps at the keys. Error of a smooth motion: O(h^2) for keys h
    // apart. Equals glm::mix (MV.js mix) between neighbours.
    static Curve linear(const Keys& keys, Ends ends = Ends::open);

    // The one polynomial through all keys. The trap: at equispaced times it swings near the ends the more, the more keys
    // there are; ask swingWarning (mv/motion/nodes.h), and take chebyshevNodes for the times, or a spline.
    // The curve is evaluated in O(n) by the first barycentric form, which is as exact as the keys allow at any times
    // (backward stable); the usual second form divides two sums that both lose all their digits from about 60
    // equispaced keys on. Also refused: times so uneven that weights of one size cannot hold them; 200 equispaced or
    // Chebyshev nodes can. Source: Berrut and Trefethen, "Barycentric Lagrange interpolation", SIAM Review 46 (2004);
    // Higham, "The numerical stability of barycentric Lagrange interpolation", IMA J. Numer. Anal. 24 (2004).
    static Curve lagrange(const Keys& keys);

    // Cubic splines: twice continuously differentiable, made in O(n). The trap: each key moves the whole curve, though by
    // less than a third from key to key, and the curve may leave the range of its keys.
    // Source: de Boor, "A Practical Guide to Splines" (1978).
    //
    // Acceleration 0 at both ends, so near them the error of other motions is O(h^2).
    static Curve naturalSpline(const Keys& keys);
    // Given velocities at the ends. Error O(h^4), and cubic motions are followed exactly. Also refused: a single key, whose
    // velocity cannot be two.
    static Curve clampedSpline(const Keys& keys, const P& startVelocity, const P& endVelocity);
    // Closed: the end runs on into the start with both derivatives.
    static Curve periodicSpline(const Keys& keys);

    // Cubics from key to key whose tangent at a key is that of the parabola through the key and its two neighbours (at an
    // open end: of the parabola through the last three keys). Each key moves four spans only. Error O(h^3); once
    // continuously differentiable, not twice: the acceleration jumps at the keys.
    // The tangents are taken in a parameter, whose knots are the keys:
    // - uniform: 0, 1, 2, ... The textbook's tangent (p[i+1] - p[i-1])/2. Loops and cusps where keys are unevenly far apart.
    // - centripetal: apart by the root of the distance of the keys, which leaves no loop or cusp within a span. A key with
    //   the same value as the one before is passed over for the tangents, and the curve rests from the one to the other.
    // - times: the keys' own.
    // Within a span the time is mapped linearly onto the parameter, so that keys keep their times. The trap: where times
    // are not spread as the knots are, the velocity keeps its direction at a key but jumps in size.
    // Source: Catmull and Rom, "A class of local interpolating splines" (1974); Yuksel, Schaefer and Keyser,
    // "Parameterization and applications of Catmull-Rom curves", Computer-Aided Design 43 (2011).
    static Curve catmullRom(const Keys& keys, Knots knots = Knots::centripetal, Ends ends = Ends::open);

    // The uniform cubic B-spline with the keys as control points. The trap: it does NOT pass through the keys, but near
    // them ((p[i-1] + 4 p[i] + p[i+1])/6 at the time of key i); an open one begins and ends at the end keys, with
    // acceleration 0, since the control points beyond are 2 p[0] - p[1] and its like. The curve stays within the convex
    // hull of each four keys, and each key moves four spans only. Twice continuously differentiable where times are
    // equispaced; at others within a span the time is mapped linearly, as of catmullRom.
    static Curve bSpline(const Keys& keys, Ends ends = Ends::open);

    // The Bezier curve with the keys as control points, of one degree less than there are keys, by de Casteljau's
    // algorithm in O(n^2). The traps: it does NOT pass through the keys between the first and the last, and of the times
    // only the first and the last count. The curve stays within the convex hull of its keys.
    static Curve bezier(const Keys& keys);

    // The place of the curve at a time. A closed curve goes on before its start and after its end; refused of others:
    // times before the first key and after the last. Also refused: NaN, infinity, and keys so large that the result
    // overflows.
    P position(double time) const;
    // Position and derivatives: at a key where one jumps, that of the span which begins there.
    CurvePoint<P> at(double time) const;

    // The times of the first and the last key.
    double start() const { return breaks_.front(); }
    double end() const { return breaks_.back(); }
    bool isClosed() const { return ends_ == Ends::closed; }

    // Times, from start to end, between which the curve is infinitely often differentiable: where to cut an integral. A
    // single one where there is one key.
    const std::vector<double>& breaks() const { return breaks_; }

    // How a kind computes; private to the library (mv/motion/curve_shape.h).
    class Shape;

  private:
    Curve(std::shared_ptr<const Shape> shape, std::vector<double> breaks, Ends ends);
    double within(double time) const;

    std::shared_ptr<const Shape> shape_;
    std::vector<double> breaks_;
    Ends ends_;
};

extern template class Curve<double>;
extern template class Curve<vec3>;

}  // namespace mv
