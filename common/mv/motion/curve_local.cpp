// Cubics of which each key moves four spans only: Catmull-Rom curves and B-splines.
#include <cmath>
#include <cstddef>
#include <utility>

#include "mv/motion/curve_shape.h"

namespace mv {
namespace {

double distance(double a, double b) { return std::abs(b - a); }
// hypot neither overflows nor vanishes for its squares.
double distance(const vec3& a, const vec3& b) { return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z); }

// The keys of a Catmull-Rom curve as its tangents see them.
template <typename P>
struct Stations {
    std::vector<P> values;
    std::vector<double> lengths;     // from each to the next, in the parameter
    std::vector<std::size_t> ofKey;  // the station of each key
};

template <typename P>
Stations<P> stationsOf(const std::vector<Keyframe<P>>& keys, Knots knots) {
    Stations<P> stations{{keys[0].value}, {}, {0}};
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const P &before = keys[i - 1].value, &value = keys[i].value;
        // Knots that are equal would divide by 0: such a key is the same station.
        if (knots != Knots::centripetal || value != before) {
            stations.lengths.push_back(knots == Knots::uniform       ? 1
                                       : knots == Knots::centripetal ? std::sqrt(distance(before, value))
                                                                     : keys[i].time - keys[i - 1].time);
            stations.values.push_back(value);
        }
        stations.ofKey.push_back(stations.values.size() - 1);
    }
    return stations;
}

// The tangents at the stations, per unit of the parameter.
template <typename P>
std::vector<P> tangentsOf(const Stations<P>& stations, Ends ends) {
    const std::size_t last = stations.lengths.size();
    const auto slope = [&](std::size_t i) {
        return (stations.values[i + 1] - stations.values[i]) / stations.lengths[i];
    };
    // The slopes of the parabola through three stations: where the spans before and after the middle one meet, and at
    // either end.
    const auto within = [&](std::size_t before, std::size_t after) {
        const double part = stations.lengths[before] / (stations.lengths[before] + stations.lengths[after]);
        return (1 - part) * slope(before) + part * slope(after);
    };
    const auto beyond = [&](std::size_t outer, std::size_t inner) {
        const double part = stations.lengths[outer] / (stations.lengths[outer] + stations.lengths[inner]);
        return slope(outer) + part * (slope(outer) - slope(inner));
    };
    std::vector<P> tangents(last + 1, P(0));
    if (last == 0) return tangents;
    for (std::size_t i = 1; i < last; ++i) tangents[i] = within(i - 1, i);
    if (ends == Ends::closed) {
        tangents[0] = tangents[last] = within(last - 1, 0);
    } else if (last == 1) {
        tangents[0] = tangents[1] = slope(0);
    } else {
        tangents[0] = beyond(0, 1);
        tangents[last] = beyond(last - 1, last - 2);
    }
    return tangents;
}

}  // namespace

template <typename P>
ShapePointer<P> catmullRomShape(const std::vector<Keyframe<P>>& keys, Knots knots, Ends ends) {
    const Stations<P> stations = stationsOf(keys, knots);
    const std::vector<P> tangents = tangentsOf(stations, ends);
    std::vector<CubicSpan<P>> spans;
    spans.reserve(keys.size() - 1);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const P from = keys[i].value, to = keys[i + 1].value;
        const double h = keys[i + 1].time - keys[i].time;
        const std::size_t station = stations.ofKey[i];
        if (stations.ofKey[i + 1] == station) {  // at rest
            spans.push_back({keys[i].time, h, {from, from, from, from}, {P(0), P(0), P(0)}, {P(0), P(0)}});
            continue;
        }
        const double parameterPerTime = stations.lengths[station] / h;
        const P first = parameterPerTime * tangents[station], last = parameterPerTime * tangents[station + 1];
        const P middle = 3.0 * ((to - from) / h) - first - last;
        spans.push_back({keys[i].time,
                         h,
                         {from, from + h / 3 * first, to - h / 3 * last, to},
                         {first, middle, last},
                         {2.0 * ((middle - first) / h), 2.0 * ((last - middle) / h)}});
    }
    return cubicShape("Curve::catmullRom", std::move(spans));
}

template <typename P>
ShapePointer<P> bSplineShape(const std::vector<Keyframe<P>>& keys, Ends ends) {
    const std::size_t last = keys.size() - 1;
    // The control points, one more at either end.
    std::vector<P> points;
    const bool isClosed = ends == Ends::closed;
    points.push_back(isClosed ? keys[last - 1].value : 2.0 * keys[0].value - keys[1].value);
    for (const Keyframe<P>& key : keys) points.push_back(key.value);
    points.push_back(isClosed ? keys[1].value : 2.0 * keys[last].value - keys[last - 1].value);
    std::vector<CubicSpan<P>> spans;
    spans.reserve(last);
    for (std::size_t i = 0; i < last; ++i) {
        const P &a = points[i], &b = points[i + 1], &c = points[i + 2], &d = points[i + 3];
        const double h = keys[i + 1].time - keys[i].time;
        spans.push_back({keys[i].time,
                         h,
                         {(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0, (b + 4.0 * c + d) / 6.0},
                         {(c - a) / 2.0 / h, (c - b) / h, (d - b) / 2.0 / h},
                         {((c - b) - (b - a)) / h / h, ((d - c) - (c - b)) / h / h}});
    }
    // An open end is its key, where 2 p[0] - p[1] is rounded.
    if (!isClosed) {
        spans.front().position[0] = keys.front().value;
        spans.back().position[3] = keys.back().value;
        spans.front().acceleration[0] = spans.back().acceleration[1] = P(0);
    }
    return cubicShape("Curve::bSpline", std::move(spans));
}

template ShapePointer<double> catmullRomShape(const std::vector<Keyframe<double>>&, Knots, Ends);
template ShapePointer<vec3> catmullRomShape(const std::vector<Keyframe<vec3>>&, Knots, Ends);
template ShapePointer<double> bSplineShape(const std::vector<Keyframe<double>>&, Ends);
template ShapePointer<vec3> bSplineShape(const std::vector<Keyframe<vec3>>&, Ends);

}  // namespace mv
