#include "mv/motion/arc_length.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/motion/gauss.h"

namespace mv {
namespace {

// hypot neither overflows nor vanishes for its squares.
double sizeOf(const vec3& v) { return std::hypot(v.x, v.y, v.z); }

double speedAt(const Curve<vec3>& curve, double time) { return sizeOf(curve.at(time).velocity); }

double integrate(const Curve<vec3>& curve, const GaussRule& rule, double from, double to) {
    const double half = (to - from) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        sum += rule.weights[i] * speedAt(curve, std::min(from + half * (1 + rule.nodes[i]), to));
    }
    return half * sum;
}

const GaussRule& tableRule() {
    static const GaussRule rule = gaussLegendre(10);
    return rule;
}

// The time of the i-th of `count` equal steps, with both ends exactly.
double timeOfStep(const Curve<vec3>& curve, int i, int count) {
    const double u = static_cast<double>(i) / count;
    return (1 - u) * curve.start() + u * curve.end();
}

constexpr int mostSteps = 10'000'000;

}  // namespace

ArcLength::ArcLength(Curve<vec3> curve, double tolerance) : curve_(std::move(curve)), tolerance_(tolerance) {
    if (!(tolerance >= 1e-13 && tolerance <= 0.1)) {
        throw Error("ArcLength", "the tolerance must be 1e-13 to 0.1", numberText(tolerance));
    }
    const std::vector<double>& breaks = curve_.breaks();
    std::vector<double> estimates;
    double about = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        estimates.push_back(integral(breaks[i], breaks[i + 1]));
        about += estimates.back();
    }
    requireFinite("ArcLength", "the length", about);
    // Half of what is tolerated is each part's own, the other half is shared out by their times.
    const double allowed = tolerance_ / 2 * about / (curve_.end() - curve_.start());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) add(breaks[i], breaks[i + 1], estimates[i], allowed);
    if (leaves_.empty()) leaves_.push_back({curve_.start(), curve_.end(), 0, 0});  // a single key
}

double ArcLength::integral(double from, double to) const { return integrate(curve_, tableRule(), from, to); }

// Appends leaves for these times. `whole`: their integral; `allowed`: the error that is allowed in a unit of time.
void ArcLength::add(double from, double to, double whole, double allowed) {
    const double middle = from + (to - from) / 2;
    const double first = integral(from, middle), second = integral(middle, to);
    const double off = std::abs(first + second - whole);
    const bool isGood = off <= std::max(tolerance_ / 2 * whole, allowed * (to - from));
    if (!isGood && from < middle && middle < to) {
        add(from, middle, first, allowed);
        add(middle, to, second, allowed);
        return;
    }
    const double before = leaves_.empty() ? 0 : leaves_.back().after;
    leaves_.push_back({from, middle, before, before + first});
    leaves_.push_back({middle, to, before + first, before + first + second});
}

// The way at a time within the leaf.
double ArcLength::partOf(const Leaf& leaf, double time) const {
    return time >= leaf.end ? leaf.after : std::min(leaf.before + integral(leaf.start, time), leaf.after);
}

double ArcLength::lengthAt(double time) const {
    if (!(time >= curve_.start() && time <= curve_.end())) {
        const std::string range = numberText(curve_.start()) + " to " + numberText(curve_.end());
        throw Error("ArcLength::lengthAt", "the time must be " + range, numberText(time));
    }
    const auto after = std::upper_bound(leaves_.begin() + 1, leaves_.end(), time,
                                        [](double t, const Leaf& leaf) { return t < leaf.start; });
    return partOf(*(after - 1), time);
}

double ArcLength::timeAt(double way) const {
    if (!(way >= 0 && way <= length())) {
        throw Error("ArcLength::timeAt", "the way must be 0 to " + numberText(length()), numberText(way));
    }
    const Leaf& leaf =
        *std::lower_bound(leaves_.begin(), leaves_.end(), way, [](const Leaf& l, double w) { return l.after < w; });
    if (way <= leaf.before) return leaf.start;
    double low = leaf.start, high = leaf.end;
    double time = low + (high - low) * ((way - leaf.before) / (leaf.after - leaf.before));
    for (;;) {
        const double off = partOf(leaf, time) - way;
        if (std::abs(off) <= 0x1p-50 * way) return time;
        (off < 0 ? low : high) = time;
        const double newton = time - off / speedAt(curve_, time);
        const double next = newton > low && newton < high ? newton : low + (high - low) / 2;
        if (!(next > low && next < high)) return high;
        time = next;
    }
}

double arcLengthByChords(const Curve<vec3>& curve, int count) {
    requireRange("arcLengthByChords", "count", count, 1, mostSteps);
    double length = 0;
    vec3 before = curve.position(curve.start());
    for (int i = 1; i <= count; ++i) {
        const vec3 place = curve.position(timeOfStep(curve, i, count));
        length += sizeOf(place - before);
        before = place;
    }
    return length;
}

double arcLengthBySimpson(const Curve<vec3>& curve, int count) {
    requireRange("arcLengthBySimpson", "count", count, 2, mostSteps);
    if (count % 2 != 0) throw Error("arcLengthBySimpson", "count must be even", std::to_string(count));
    double sum = speedAt(curve, curve.start()) + speedAt(curve, curve.end());
    for (int i = 1; i < count; ++i) sum += (i % 2 == 0 ? 2 : 4) * speedAt(curve, timeOfStep(curve, i, count));
    return (curve.end() - curve.start()) / 3 / count * sum;
}

double arcLengthByGauss(const Curve<vec3>& curve, int count) {
    const GaussRule rule = gaussLegendre(count);
    double length = 0;
    for (std::size_t i = 0; i + 1 < curve.breaks().size(); ++i) {
        length += integrate(curve, rule, curve.breaks()[i], curve.breaks()[i + 1]);
    }
    return length;
}

}  // namespace mv
