// How the kinds of curves compute; private to the library, where curve.h is what others see.
#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/motion/curve.h"

namespace mv {

// A curve from its first key to its last: who asks has checked the time. A number that overflows comes out infinite or
// NaN, and is refused by Curve.
template <typename P>
class Curve<P>::Shape {
  public:
    Shape() = default;
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;
    virtual ~Shape() = default;
    virtual P position(double time) const = 0;
    virtual CurvePoint<P> at(double time) const = 0;
};

template <typename P>
using ShapePointer = std::shared_ptr<const typename Curve<P>::Shape>;

// The kinds, for checked keys, two at least. Refused: what overflows when the curve is made.
template <typename P>
ShapePointer<P> linearShape(const std::vector<Keyframe<P>>& keys);
template <typename P>
ShapePointer<P> naturalShape(const std::vector<Keyframe<P>>& keys);
template <typename P>
ShapePointer<P> clampedShape(const std::vector<Keyframe<P>>& keys, const P& startVelocity, const P& endVelocity);
template <typename P>
ShapePointer<P> periodicShape(const std::vector<Keyframe<P>>& keys);
template <typename P>
ShapePointer<P> catmullRomShape(const std::vector<Keyframe<P>>& keys, Knots knots, Ends ends);
template <typename P>
ShapePointer<P> bSplineShape(const std::vector<Keyframe<P>>& keys, Ends ends);
template <typename P>
ShapePointer<P> lagrangeShape(const std::vector<Keyframe<P>>& keys);
template <typename P>
ShapePointer<P> bezierShape(const std::vector<Keyframe<P>>& keys);

// The cubic of one span, as three Bernstein polynomials: of position, velocity and acceleration. At both ends they are
// what was given, without rounding. Each derivative has its own, since differences of positions would lose its digits.
template <typename P>
struct CubicSpan {
    double start, length;  // in time
    P position[4], velocity[3], acceleration[2];
};
template <typename P>
ShapePointer<P> cubicShape(const char* subject, std::vector<CubicSpan<P>> spans);

inline std::string valueText(double value) { return numberText(value); }
inline std::string valueText(const vec3& value) { return vectorText(value); }

[[noreturn]] inline void refuseOverflow(const char* subject) {
    throw Error(subject, "the keys must not be so large, or so close in time, that the curve overflows");
}

}  // namespace mv
