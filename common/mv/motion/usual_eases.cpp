#include "mv/motion/usual_eases.h"

#include <cmath>

#include "mv/error.h"
#include "mv/math/types.h"

namespace mv {
namespace {

void requireShare(const char* subject, double t) {
    if (!(t >= 0 && t <= 1)) throw Error(subject, "t must be 0 to 1", numberText(t));
}

using Curve = double (*)(double);

double sided(const char* subject, Curve in, double t, EaseSide side) {
    requireShare(subject, t);
    if (side == EaseSide::in) return in(t);
    if (side == EaseSide::out) return 1 - in(1 - t);
    return t < 0.5 ? in(2 * t) / 2 : 1 - in(2 - 2 * t) / 2;
}

double slopeSided(const char* subject, Curve slopeIn, double t, EaseSide side) {
    requireShare(subject, t);
    if (side == EaseSide::in) return slopeIn(t);
    if (side == EaseSide::out) return slopeIn(1 - t);
    return slopeIn(t < 0.5 ? 2 * t : 2 - 2 * t);
}

// Up to 1/2 as a square, which loses nothing; from there on 1 less the cosine is what is large.
double sineIn(double t) {
    const double s = std::sin(pi / 4 * t);
    return t <= 0.5 ? 2 * s * s : 1 - std::sin(pi / 2 * (1 - t));
}
double sineInSlope(double t) { return pi / 2 * std::sin(pi / 2 * t); }

constexpr double overshoot = 1.70158;
double backIn(double t) { return t * t * (t - overshoot * (1 - t)); }
double backInSlope(double t) { return t * (3 * (overshoot + 1) * t - 2 * overshoot); }

// In steps of t - 1, which are exact near the end that matters.
constexpr double third = 2 * pi / 3;
double elasticIn(double t) {
    if (t == 0 || t == 1) return t;
    return -std::exp2(10 * (t - 1)) * std::sin(third * (10 * (t - 1) - 0.75));
}
double elasticInSlope(double t) {
    const double angle = third * (10 * (t - 1) - 0.75);
    return -10 * std::exp2(10 * (t - 1)) * (std::log(2.0) * std::sin(angle) + third * std::cos(angle));
}

// The parabola that the ball is on at `time`, in units of 4/11: its middle and the height from which it falls.
struct Bounce {
    double middle, height;
};
Bounce bounceAt(double time) {
    if (time < 1) return {0, 1};
    if (time < 2) return {1.5, 0.25};
    if (time < 2.5) return {2.25, 0.0625};
    return {2.625, 0.015625};
}
double bounceIn(double t) {
    const double time = 2.75 * (1 - t), from = time - bounceAt(time).middle;
    return bounceAt(time).height - from * from;
}
double bounceInSlope(double t) {
    const double time = 2.75 * (1 - t);
    return 5.5 * (time - bounceAt(time).middle);
}

}  // namespace

double cubicEase(double t, EaseSide side) {
    return sided(
        "cubicEase", [](double x) { return x * x * x; }, t, side);
}
double cubicEaseSlope(double t, EaseSide side) {
    return slopeSided(
        "cubicEaseSlope", [](double x) { return 3 * x * x; }, t, side);
}

double sineEase(double t, EaseSide side) { return sided("sineEase", sineIn, t, side); }
double sineEaseSlope(double t, EaseSide side) { return slopeSided("sineEaseSlope", sineInSlope, t, side); }

double backEase(double t, EaseSide side) { return sided("backEase", backIn, t, side); }
double backEaseSlope(double t, EaseSide side) { return slopeSided("backEaseSlope", backInSlope, t, side); }

double elasticEase(double t, EaseSide side) { return sided("elasticEase", elasticIn, t, side); }
double elasticEaseSlope(double t, EaseSide side) { return slopeSided("elasticEaseSlope", elasticInSlope, t, side); }

double bounceEase(double t, EaseSide side) { return sided("bounceEase", bounceIn, t, side); }
double bounceEaseSlope(double t, EaseSide side) { return slopeSided("bounceEaseSlope", bounceInSlope, t, side); }

double stepsEase(double t, int steps) {
    requireShare("stepsEase", t);
    if (steps < 1 || steps > 1'000'000) throw Error("stepsEase", "steps must be 1 to 1e6", numberText(steps));
    return std::floor(steps * t) / steps;
}

}  // namespace mv
