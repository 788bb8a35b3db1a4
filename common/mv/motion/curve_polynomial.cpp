// Curves that are one polynomial: Lagrange's through the keys, and Bezier's.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "mv/math/robust.h"
#include "mv/motion/curve_shape.h"

namespace mv {
namespace {

template <typename P>
class LagrangeShape final : public Curve<P>::Shape {
  public:
    explicit LagrangeShape(const std::vector<Keyframe<P>>& keys)
        : perUnit_(4 / (keys.back().time - keys.front().time)) {
        for (const Keyframe<P>& key : keys) {
            times_.push_back(key.time);
            positions_.push_back(key.value);
        }
        makeWeights();
        velocities_ = derivative(positions_);
        accelerations_ = derivative(velocities_);
    }

    P position(double time) const override { return evaluate<1>(time, {&positions_})[0]; }
    CurvePoint<P> at(double time) const override {
        const auto all = evaluate<3>(time, {&positions_, &velocities_, &accelerations_});
        return {all[0], all[1], all[2]};
    }

  private:
    // Weight j is 1 over the product of (t[j] - t[k]) in units of a quarter of the times' range, the unit in which such
    // products neither grow nor shrink exponentially (the capacity of the interval). The rest of their sizes goes into
    // one exponent for all, and the largest weight is 1 to 2 in size.
    void makeWeights() {
        std::vector<int> exponents;
        for (const double time : times_) {
            double product = 1;
            int exponent = 0;
            for (const double other : times_) {
                if (other == time) continue;
                const double factor = (time - other) * perUnit_;
                if (!(std::abs(factor) > 1e-150)) refuseUneven();
                product = takeExponent(product * factor, exponent);
            }
            int taken = 0;
            weights_.push_back(1 / std::frexp(product, &taken));
            exponents.push_back(-exponent - taken);
        }
        exponent_ = *std::ranges::max_element(exponents);
        for (std::size_t j = 0; j < weights_.size(); ++j) {
            if (exponents[j] < exponent_ - 900) refuseUneven();
            weights_[j] = std::ldexp(weights_[j], exponents[j] - exponent_);
        }
    }

    [[noreturn]] static void refuseUneven() {
        throw Error("Curve::lagrange",
                    "the times must not be so uneven that the weights differ by more than a factor of 1e270");
    }

    // The number, or where it leaves the ordinary range its digits, whose exponent is added to `exponent`.
    static double takeExponent(double number, int& exponent) {
        if (isOrdinary(std::abs(number))) return number;
        int taken = 0;
        number = std::frexp(number, &taken);
        exponent += taken;
        return number;
    }

    // The derivatives at the nodes of the polynomial with these values there. Differences are taken of the values, since a
    // diagonal of the matrix by its own formula would leave a constant with a derivative.
    // Source: Berrut and Trefethen (2004), section 9.3; Baltensperger and Trummer, "Spectral differencing with a twist",
    // SIAM J. Sci. Comput. 24 (2003).
    std::vector<P> derivative(const std::vector<P>& values) const {
        std::vector<P> derivatives(values.size(), P(0));
        for (std::size_t i = 0; i < values.size(); ++i) {
            for (std::size_t j = 0; j < values.size(); ++j) {
                if (i == j) continue;
                derivatives[i] += weights_[j] / weights_[i] * ((values[j] - values[i]) / (times_[i] - times_[j]));
            }
            if (!isFinite(derivatives[i])) refuseOverflow("Curve::lagrange");
        }
        return derivatives;
    }

    // The polynomials with these values at the nodes. Sum and product are both multiplied by the distance from the nearest
    // node, the one that may be tiny: then no quotient is above 1.
    template <std::size_t N>
    std::array<P, N> evaluate(double time, const std::array<const std::vector<P>*, N>& values) const {
        const std::size_t nearest = nearestTo(time);
        const double near = time - times_[nearest];
        std::array<P, N> sums{};
        if (near == 0) {
            for (std::size_t k = 0; k < N; ++k) sums[k] = (*values[k])[nearest];
            return sums;
        }
        double product = 1;
        int exponent = exponent_;
        for (std::size_t j = 0; j < times_.size(); ++j) {
            const double away = time - times_[j];
            if (j != nearest) product = takeExponent(product * (away * perUnit_), exponent);
            const double factor = weights_[j] * (near / away);
            for (std::size_t k = 0; k < N; ++k) sums[k] += factor * (*values[k])[j];
        }
        const double scale = std::scalbn(product, exponent);
        for (P& sum : sums) sum *= scale;
        return sums;
    }

    std::size_t nearestTo(double time) const {
        const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
        const auto index = static_cast<std::size_t>(after - times_.begin());
        return time - times_[index - 1] < times_[index] - time ? index - 1 : index;
    }

    double perUnit_;
    std::vector<double> times_, weights_;
    int exponent_ = 0;
    std::vector<P> positions_, velocities_, accelerations_;
};

template <typename P>
class BezierShape final : public Curve<P>::Shape {
  public:
    explicit BezierShape(const std::vector<Keyframe<P>>& keys)
        : start_(keys.front().time), length_(keys.back().time - keys.front().time) {
        for (const Keyframe<P>& key : keys) positions_.push_back(key.value);
        velocities_ = derivative(positions_);
        accelerations_ = derivative(velocities_);
    }

    P position(double time) const override { return deCasteljau(positions_, (time - start_) / length_); }
    CurvePoint<P> at(double time) const override {
        const double u = (time - start_) / length_;
        return {deCasteljau(positions_, u), deCasteljau(velocities_, u), deCasteljau(accelerations_, u)};
    }

  private:
    // The control points of the derivative, which has one degree less; that of a constant is 0.
    std::vector<P> derivative(const std::vector<P>& points) const {
        if (points.size() == 1) return {P(0)};
        const auto degree = static_cast<double>(points.size() - 1);
        std::vector<P> derivatives;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            derivatives.push_back(degree * ((points[i + 1] - points[i]) / length_));
            if (!isFinite(derivatives.back())) refuseOverflow("Curve::bezier");
        }
        return derivatives;
    }

    static P deCasteljau(std::vector<P> points, double u) {
        for (std::size_t count = points.size() - 1; count > 0; --count) {
            for (std::size_t i = 0; i < count; ++i) points[i] = (1 - u) * points[i] + u * points[i + 1];
        }
        return points[0];
    }

    double start_, length_;
    std::vector<P> positions_, velocities_, accelerations_;
};

}  // namespace

template <typename P>
ShapePointer<P> lagrangeShape(const std::vector<Keyframe<P>>& keys) {
    return std::make_shared<LagrangeShape<P>>(keys);
}

template <typename P>
ShapePointer<P> bezierShape(const std::vector<Keyframe<P>>& keys) {
    return std::make_shared<BezierShape<P>>(keys);
}

template ShapePointer<double> lagrangeShape(const std::vector<Keyframe<double>>&);
template ShapePointer<vec3> lagrangeShape(const std::vector<Keyframe<vec3>>&);
template ShapePointer<double> bezierShape(const std::vector<Keyframe<double>>&);
template ShapePointer<vec3> bezierShape(const std::vector<Keyframe<vec3>>&);

}  // namespace mv
