#include "mv/motion/curve.h"

#include <utility>

#include "mv/motion/curve_shape.h"

namespace mv {
namespace {

template <typename P>
void requireKeys(const char* subject, const std::vector<Keyframe<P>>& keys, Ends ends) {
    if (keys.empty()) throw Error(subject, "there must be one key at least", "0 keys");
    for (std::size_t i = 0; i < keys.size(); ++i) {
        requireFinite(subject, "the time of a key", keys[i].time);
        requireFinite(subject, "the value of a key", keys[i].value);
        if (i > 0 && !(keys[i - 1].time < keys[i].time)) {
            throw Error(subject, "times must increase from key to key",
                        numberText(keys[i].time) + " after " + numberText(keys[i - 1].time));
        }
    }
    requireFinite(subject, "the time from the first key to the last", keys.back().time - keys.front().time);
    if (ends == Ends::closed && keys.front().value != keys.back().value) {
        throw Error(subject,
                    "the last key of a closed curve must have the value of the first, " + valueText(keys.front().value),
                    valueText(keys.back().value));
    }
}

template <typename P>
class ConstantShape final : public Curve<P>::Shape {
  public:
    explicit ConstantShape(const P& value) : value_(value) {}
    P position(double) const override { return value_; }
    CurvePoint<P> at(double) const override { return {value_, P(0), P(0)}; }

  private:
    P value_;
};

template <typename P>
std::vector<double> timesOf(const std::vector<Keyframe<P>>& keys) {
    std::vector<double> times;
    times.reserve(keys.size());
    for (const Keyframe<P>& key : keys) times.push_back(key.time);
    return times;
}

template <typename P>
std::vector<double> endsOf(const std::vector<Keyframe<P>>& keys) {
    if (keys.size() == 1) return {keys.front().time};
    return {keys.front().time, keys.back().time};
}

// The shape that make() gives, or a constant where there is one key.
template <typename P, typename Make>
ShapePointer<P> shapeOf(const char* subject, const std::vector<Keyframe<P>>& keys, Ends ends, Make make) {
    requireKeys(subject, keys, ends);
    if (keys.size() == 1) return std::make_shared<ConstantShape<P>>(keys.front().value);
    return make();
}

}  // namespace

template <typename P>
Curve<P>::Curve(std::shared_ptr<const Shape> shape, std::vector<double> breaks, Ends ends)
    : shape_(std::move(shape)), breaks_(std::move(breaks)), ends_(ends) {}

template <typename P>
Curve<P> Curve<P>::linear(const Keys& keys, Ends ends) {
    auto shape = shapeOf("Curve::linear", keys, ends, [&] { return linearShape(keys); });
    return {std::move(shape), timesOf(keys), ends};
}

template <typename P>
Curve<P> Curve<P>::lagrange(const Keys& keys) {
    auto shape = shapeOf("Curve::lagrange", keys, Ends::open, [&] { return lagrangeShape(keys); });
    return {std::move(shape), endsOf(keys), Ends::open};
}

template <typename P>
Curve<P> Curve<P>::naturalSpline(const Keys& keys) {
    auto shape = shapeOf("Curve::naturalSpline", keys, Ends::open, [&] { return naturalShape(keys); });
    return {std::move(shape), timesOf(keys), Ends::open};
}

template <typename P>
Curve<P> Curve<P>::clampedSpline(const Keys& keys, const P& startVelocity, const P& endVelocity) {
    const char* subject = "Curve::clampedSpline";
    requireKeys(subject, keys, Ends::open);
    if (keys.size() == 1) throw Error(subject, "there must be two keys at least", "1 key");
    requireFinite(subject, "the velocity at the start", startVelocity);
    requireFinite(subject, "the velocity at the end", endVelocity);
    return {clampedShape(keys, startVelocity, endVelocity), timesOf(keys), Ends::open};
}

template <typename P>
Curve<P> Curve<P>::periodicSpline(const Keys& keys) {
    auto shape = shapeOf("Curve::periodicSpline", keys, Ends::closed, [&] { return periodicShape(keys); });
    return {std::move(shape), timesOf(keys), Ends::closed};
}

template <typename P>
Curve<P> Curve<P>::catmullRom(const Keys& keys, Knots knots, Ends ends) {
    auto shape = shapeOf("Curve::catmullRom", keys, ends, [&] { return catmullRomShape(keys, knots, ends); });
    return {std::move(shape), timesOf(keys), ends};
}

template <typename P>
Curve<P> Curve<P>::bSpline(const Keys& keys, Ends ends) {
    auto shape = shapeOf("Curve::bSpline", keys, ends, [&] { return bSplineShape(keys, ends); });
    return {std::move(shape), timesOf(keys), ends};
}

template <typename P>
Curve<P> Curve<P>::bezier(const Keys& keys) {
    auto shape = shapeOf("Curve::bezier", keys, Ends::open, [&] { return bezierShape(keys); });
    return {std::move(shape), endsOf(keys), Ends::open};
}

// The time between the first key and the last at which a curve has the value that is asked for.
template <typename P>
double Curve<P>::within(double time) const {
    if (time >= start() && (time < end() || (time == end() && !isClosed()))) return time;
    requireFinite("Curve", "the time", time);
    if (breaks_.size() == 1) return start();
    if (!isClosed()) {
        throw Error("Curve", "the time must be " + numberText(start()) + " to " + numberText(end()), numberText(time));
    }
    // fmod rounds nothing, so a time far away is as exact as its distance from the start.
    const double period = end() - start(), away = time - start();
    requireFinite("Curve", "the time from the start", away);
    const double rest = std::fmod(away, period);
    const double inside = start() + (rest < 0 ? rest + period : rest);
    return inside < end() ? inside : start();
}

template <typename P>
P Curve<P>::position(double time) const {
    const P position = shape_->position(within(time));
    if (!isFinite(position)) refuseOverflow("Curve::position");
    return position;
}

template <typename P>
CurvePoint<P> Curve<P>::at(double time) const {
    const CurvePoint<P> point = shape_->at(within(time));
    if (!isFinite(point.position) || !isFinite(point.velocity) || !isFinite(point.acceleration)) {
        refuseOverflow("Curve::at");
    }
    return point;
}

template class Curve<double>;
template class Curve<vec3>;

}  // namespace mv
