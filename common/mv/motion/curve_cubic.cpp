// Curves that are a cubic, or a line, from key to key.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "mv/motion/curve_shape.h"

namespace mv {
namespace {

// The last of the spans that begins at or before the time, the first where none does.
template <typename Span>
const Span& spanAt(const std::vector<Span>& spans, double time) {
    const auto after = std::upper_bound(spans.begin() + 1, spans.end(), time,
                                        [](double t, const Span& span) { return t < span.start; });
    return *(after - 1);
}

template <typename P>
struct LinearSpan {
    double start, length;
    P from, to, velocity;
};

template <typename P>
class LinearShape final : public Curve<P>::Shape {
  public:
    explicit LinearShape(const std::vector<Keyframe<P>>& keys) {
        spans_.reserve(keys.size() - 1);
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
            const double length = keys[i + 1].time - keys[i].time;
            const P velocity = (keys[i + 1].value - keys[i].value) / length;
            if (!isFinite(velocity)) refuseOverflow("Curve::linear");
            spans_.push_back({keys[i].time, length, keys[i].value, keys[i + 1].value, velocity});
        }
    }

    P position(double time) const override { return between(spanAt(spans_, time), time); }
    CurvePoint<P> at(double time) const override {
        const LinearSpan<P>& span = spanAt(spans_, time);
        return {between(span, time), span.velocity, P(0)};
    }

  private:
    // Both ends exactly, where from + u (to - from) would miss the second.
    static P between(const LinearSpan<P>& span, double time) {
        const double u = (time - span.start) / span.length;
        return (1 - u) * span.from + u * span.to;
    }

    std::vector<LinearSpan<P>> spans_;
};

template <typename P>
class CubicShape final : public Curve<P>::Shape {
  public:
    explicit CubicShape(std::vector<CubicSpan<P>> spans) : spans_(std::move(spans)) {}

    P position(double time) const override {
        const CubicSpan<P>& span = spanAt(spans_, time);
        return position(span, (time - span.start) / span.length);
    }
    CurvePoint<P> at(double time) const override {
        const CubicSpan<P>& span = spanAt(spans_, time);
        const double u = (time - span.start) / span.length, v = 1 - u;
        const P velocity = v * (v * span.velocity[0] + 2 * u * span.velocity[1]) + u * u * span.velocity[2];
        return {position(span, u), velocity, v * span.acceleration[0] + u * span.acceleration[1]};
    }

  private:
    static P position(const CubicSpan<P>& span, double u) {
        const double v = 1 - u;
        return v * v * (v * span.position[0] + 3 * u * span.position[1]) +
               u * u * (3 * v * span.position[2] + u * span.position[3]);
    }

    std::vector<CubicSpan<P>> spans_;
};

}  // namespace

template <typename P>
ShapePointer<P> linearShape(const std::vector<Keyframe<P>>& keys) {
    return std::make_shared<LinearShape<P>>(keys);
}

template <typename P>
ShapePointer<P> cubicShape(const char* subject, std::vector<CubicSpan<P>> spans) {
    for (const CubicSpan<P>& span : spans) {
        const auto finite = [](const P& p) { return isFinite(p); };
        if (!std::ranges::all_of(span.position, finite) || !std::ranges::all_of(span.velocity, finite) ||
            !std::ranges::all_of(span.acceleration, finite)) {
            refuseOverflow(subject);
        }
    }
    return std::make_shared<CubicShape<P>>(std::move(spans));
}

template ShapePointer<double> linearShape(const std::vector<Keyframe<double>>&);
template ShapePointer<vec3> linearShape(const std::vector<Keyframe<vec3>>&);
template ShapePointer<double> cubicShape(const char*, std::vector<CubicSpan<double>>);
template ShapePointer<vec3> cubicShape(const char*, std::vector<CubicSpan<vec3>>);

}  // namespace mv
