#include "mv/motion/ease.h"

#include <cmath>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

void requirePart(const char* subject, double t) {
    if (!(t >= 0 && t <= 1)) throw Error(subject, "t must be 0 to 1", numberText(t));
}

void requireSteepness(const char* subject, double steepness) {
    if (!(steepness >= 1e-6 && steepness <= 1e6)) {
        throw Error(subject, "the steepness must be 1e-6 to 1e6", numberText(steepness));
    }
}

// The curve up to t = 1/2, where its exponentials are at most 1. As differences of exponentials, which lose no digits
// where those of the logistic function do.
double lowerHalf(double t, double steepness) {
    const double q = std::exp(steepness * (t - 0.5));
    return q / (1 + q) * (std::expm1(-steepness * t) / std::expm1(-steepness / 2));
}

// A cubic Bezier polynomial from 0 to 1 with these two values between, and its derivatives.
double bernstein(double a, double b, double s) {
    const double r = 1 - s;
    return s * (3 * r * (r * a + s * b) + s * s);
}
double bernsteinSlope(double a, double b, double s) {
    const double r = 1 - s;
    return 3 * (r * r * a + 2 * r * s * (b - a) + s * s * (1 - b));
}
double bernsteinBend(double a, double b, double s) { return 6 * ((1 - s) * (b - 2 * a) + s * (1 + a - 2 * b)); }

}  // namespace

double linearEase(double t) {
    requirePart("linearEase", t);
    return t;
}

double linearEaseSlope(double t) {
    requirePart("linearEaseSlope", t);
    return 1;
}

double rootEase(double t) {
    requirePart("rootEase", t);
    return std::sqrt(t);
}

double rootEaseSlope(double t) {
    requirePart("rootEaseSlope", t);
    if (t == 0) throw Error("rootEaseSlope", "t must be above 0, where the slope is infinite", "0");
    return 0.5 / std::sqrt(t);
}

double quadraticEase(double t) {
    requirePart("quadraticEase", t);
    return t * t;
}

double quadraticEaseSlope(double t) {
    requirePart("quadraticEaseSlope", t);
    return 2 * t;
}

double logisticEase(double t, double steepness) {
    requirePart("logisticEase", t);
    requireSteepness("logisticEase", steepness);
    return t <= 0.5 ? lowerHalf(t, steepness) : 1 - lowerHalf(1 - t, steepness);
}

double logisticEaseSlope(double t, double steepness) {
    requirePart("logisticEaseSlope", t);
    requireSteepness("logisticEaseSlope", steepness);
    const double q = std::exp(-steepness * std::abs(t - 0.5));
    return q / ((1 + q) * (1 + q)) * (steepness / std::tanh(steepness / 4));
}

BezierEase::BezierEase(const vec2& first, const vec2& second) : first_(first), second_(second) {
    for (const vec2& handle : {first, second}) {
        requireFinite("BezierEase", "a handle", handle);
        if (handle.x < 0 || handle.x > 1) throw Error("BezierEase", "a handle's x must be 0 to 1", vectorText(handle));
        if (std::abs(handle.y) > 1e100)
            throw Error("BezierEase", "a handle's y must be -1e100 to 1e100", vectorText(handle));
    }
}

double BezierEase::x(double s) const { return bernstein(first_.x, second_.x, s); }
double BezierEase::y(double s) const { return bernstein(first_.y, second_.y, s); }

double BezierEase::parameter(double t) const {
    if (t == 0 || t == 1) return t;
    // x rises from x(low) <= t to x(high) >= t.
    double low = 0, high = 1, s = t;
    for (;;) {
        const double off = x(s) - t;
        if (std::abs(off) <= 0x1p-52 * t) return s;
        (off < 0 ? low : high) = s;
        const double newton = s - off / bernsteinSlope(first_.x, second_.x, s);
        // Also where the slope is 0 and the step not a number. A small s is found by its exponent.
        const bool isWithin = newton > low && newton < high;
        const double half = low > 0 && high > 4 * low ? std::sqrt(low) * std::sqrt(high) : low + (high - low) / 2;
        const double next = isWithin ? newton : half;
        if (next == s || !(next > low && next < high)) return s;
        s = next;
    }
}

double BezierEase::value(double t) const {
    requirePart("BezierEase::value", t);
    return y(parameter(t));
}

double BezierEase::slope(double t) const {
    requirePart("BezierEase::slope", t);
    const double s = parameter(t);
    const double across = bernsteinSlope(first_.x, second_.x, s), up = bernsteinSlope(first_.y, second_.y, s);
    // A handle on its end: the slope is that of the second derivatives, or of the third.
    const double bendAcross = bernsteinBend(first_.x, second_.x, s), bendUp = bernsteinBend(first_.y, second_.y, s);
    double slope = up / across;
    if (across == 0 && up == 0) slope = bendAcross == 0 && bendUp == 0 ? 1 : bendUp / bendAcross;
    if (!isFinite(slope)) throw Error("BezierEase::slope", "t must not be where the graph is vertical", numberText(t));
    return slope;
}

}  // namespace mv
