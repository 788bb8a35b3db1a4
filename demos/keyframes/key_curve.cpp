#include "key_curve.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/motion/ease.h"
#include "mv/motion/usual_eases.h"

namespace mv {

template <class P>
typename Motion<P>::Span Motion<P>::spanAt(double time) const {
    const std::vector<double>& breaks = curve_.breaks();
    const auto next = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, time);
    const double begin = *(next - 1), length = *next - begin;
    return {curve_.at(begin), length, (time - begin) / length};
}

template <class P>
P Motion<P>::position(double time) const {
    if (!easing_.part) return curve_.position(time);
    const Span span = spanAt(time);
    return span.start.position + easing_.part(span.passed) * span.length * span.start.velocity;
}

template <class P>
CurvePoint<P> Motion<P>::at(double time) const {
    if (!easing_.part) return curve_.at(time);
    const Span span = spanAt(time);
    const P velocity = span.start.velocity;
    return {position(time), velocity == P(0) ? velocity : easing_.slope(span.passed) * velocity, P(0)};
}

template <class P>
CurvePoint<P> Motion<P>::before(double key) const {
    if (key > curve_.start()) return at(std::nextafter(key, curve_.start()));
    if (curve_.isClosed()) return before(end());
    return {position(key), P(0), P(0)};
}

template <class P>
CurvePoint<P> Motion<P>::after(double key) const {
    if (key < end()) return at(key);
    if (curve_.isClosed()) return at(curve_.start());
    return {position(key), P(0), P(0)};
}

template class Motion<double>;
template class Motion<vec3>;

Jumps jumpsOf(const Motion<vec3>& motion, const std::vector<double>& times) {
    Jumps jumps;
    const bool isClosed = motion.curve().isClosed();
    const double start = motion.curve().start();
    for (const double time : times) {
        if (!isClosed && (time <= start || time >= motion.end())) continue;
        const CurvePoint<vec3> before = motion.before(time), after = motion.after(time);
        jumps.velocity = std::max(jumps.velocity, glm::length(after.velocity - before.velocity));
        jumps.acceleration = std::max(jumps.acceleration, glm::length(after.acceleration - before.acceleration));
    }
    if (!isClosed) {
        jumps.end =
            std::max(glm::length(motion.after(start).velocity), glm::length(motion.before(motion.end()).velocity));
    }
    return jumps;
}

namespace {

constexpr int jumps = 5;  // of the ease by steps

}  // namespace

template <class P>
Motion<P> KeyCurve::through(const std::vector<Keyframe<P>>& keys, const P& startVelocity, const P& endVelocity) const {
    switch (kind) {
        case Kind::linear:
            break;
        case Kind::ease:
            return {Curve<P>::linear(keys),
                    {[curve = *this](double part) { return curve.eased(part); },
                     [curve = *this](double part) { return curve.slope(part); }}};
        case Kind::lagrange:
            return Motion<P>(Curve<P>::lagrange(keys));
        case Kind::natural:
            return Motion<P>(Curve<P>::naturalSpline(keys));
        case Kind::clamped:
            return Motion<P>(Curve<P>::clampedSpline(keys, startVelocity, endVelocity));
        case Kind::periodic:
            return Motion<P>(Curve<P>::periodicSpline(keys));
        case Kind::catmullRom:
            return Motion<P>(Curve<P>::catmullRom(keys, Knots::uniform));
        case Kind::centripetal:
            return Motion<P>(Curve<P>::catmullRom(keys, Knots::centripetal));
        case Kind::bSpline:
            return Motion<P>(Curve<P>::bSpline(keys));
        case Kind::bezier:
            return Motion<P>(Curve<P>::bezier(keys));
    }
    return Motion<P>(Curve<P>::linear(keys));
}

template Motion<double> KeyCurve::through(const std::vector<Keyframe<double>>&, const double&, const double&) const;
template Motion<vec3> KeyCurve::through(const std::vector<Keyframe<vec3>>&, const vec3&, const vec3&) const;

double KeyCurve::eased(double part) const {
    if (!isEased()) return linearEase(part);
    switch (ease) {
        case Ease::root:
            return rootEase(part);
        case Ease::quadratic:
            return quadraticEase(part);
        case Ease::logistic:
            return logisticEase(part, steepness);
        case Ease::bezier:
            break;
        case Ease::cubic:
            return cubicEase(part, EaseSide::inOut);
        case Ease::sine:
            return sineEase(part, EaseSide::inOut);
        case Ease::back:
            return backEase(part, EaseSide::inOut);
        case Ease::elastic:
            return elasticEase(part, EaseSide::out);
        case Ease::bounce:
            return bounceEase(part, EaseSide::out);
        case Ease::steps:
            return stepsEase(part, jumps);
    }
    return BezierEase(handles[0], handles[1]).value(part);
}

double KeyCurve::slope(double part) const {
    if (!isEased()) return linearEaseSlope(part);
    switch (ease) {
        case Ease::root:
            return part > 0 ? rootEaseSlope(part) : HUGE_VAL;
        case Ease::quadratic:
            return quadraticEaseSlope(part);
        case Ease::logistic:
            return logisticEaseSlope(part, steepness);
        case Ease::bezier:
            break;
        case Ease::cubic:
            return cubicEaseSlope(part, EaseSide::inOut);
        case Ease::sine:
            return sineEaseSlope(part, EaseSide::inOut);
        case Ease::back:
            return backEaseSlope(part, EaseSide::inOut);
        case Ease::elastic:
            return elasticEaseSlope(part, EaseSide::out);
        case Ease::bounce:
            return bounceEaseSlope(part, EaseSide::out);
        case Ease::steps:
            return 0;  // between its jumps
    }
    return BezierEase(handles[0], handles[1]).slope(part);
}

}  // namespace mv
