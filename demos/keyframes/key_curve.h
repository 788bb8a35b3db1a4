// A motion through keys, or near them, by the chosen kind of curve.
#pragma once
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "mv/motion/curve.h"

namespace mv {

// A motion along a curve, even in the curve's time, or eased from key to key. P is double or vec3, as for Curve.
template <class P>
class Motion {
  public:
    // For the part 0 .. 1 of the time between two keys: the part of the way, and its slope, which may be infinite.
    struct Easing {
        std::function<double(double)> part, slope;
    };
    explicit Motion(Curve<P> curve) : curve_(std::move(curve)) {}
    // The curve is linear.
    Motion(Curve<P> curve, Easing easing) : curve_(std::move(curve)), easing_(std::move(easing)) {}

    // From curve().start() to end(). The acceleration of an eased motion is not computed: 0.
    P position(double time) const;
    CurvePoint<P> at(double time) const;
    // On the two sides of a key's time, where velocity and acceleration may differ. Outside of an open curve it rests, at
    // its ends; a closed one goes on.
    CurvePoint<P> before(double key) const;
    CurvePoint<P> after(double key) const;

    const Curve<P>& curve() const { return curve_; }
    double end() const { return curve_.end(); }

  private:
    // The span between two keys that contains a time, and the part of it that has passed.
    struct Span {
        CurvePoint<P> start;
        double length, passed;
    };
    Span spanAt(double time) const;

    Curve<P> curve_;
    Easing easing_{};
};

extern template class Motion<double>;
extern template class Motion<vec3>;

// The largest jumps of velocity and acceleration, at those of these times that are not the ends of an open curve; the
// speed at which it leaves its rest at the start or comes to it at the end, whichever is larger, 0 of a closed one.
struct Jumps {
    double velocity = 0, acceleration = 0, end = 0;
};
Jumps jumpsOf(const Motion<vec3>& motion, const std::vector<double>& times);

// The choice of a curve through the keys, or near them: a part of a lesson's settings.
struct KeyCurve {
    enum class Kind { linear, ease, lagrange, natural, clamped, periodic, catmullRom, centripetal, bSpline, bezier };
    enum class Ease { root, quadratic, logistic, bezier, cubic, sine, back, elastic, bounce, steps };

    Kind kind = Kind::linear;
    Ease ease = Ease::logistic;
    double steepness = 10;                                    // of the logistic ease
    std::array<vec2, 2> handles{vec2(0.4, 0), vec2(0.6, 1)};  // of the Bezier ease

    // Refused: as by the functions of Curve; keys of a periodic spline end with the first key's value.
    // The velocities are for the clamped spline.
    template <class P>
    Motion<P> through(const std::vector<Keyframe<P>>& keys, const P& startVelocity, const P& endVelocity) const;

    // The motion through each span between two keys by linear and ease, and its slope.
    double eased(double part) const;
    double slope(double part) const;

    bool isEased() const { return kind == Kind::ease; }
    bool isLogistic() const { return isEased() && ease == Ease::logistic; }
    bool isBezierEase() const { return isEased() && ease == Ease::bezier; }
    // Whether it leaves each key at infinite speed.
    bool startsAtOnce() const { return isEased() && ease == Ease::root; }
    // Whether it is straight from key to key.
    bool isStraight() const { return kind == Kind::linear || isEased(); }

    bool operator==(const KeyCurve&) const = default;
};

}  // namespace mv
