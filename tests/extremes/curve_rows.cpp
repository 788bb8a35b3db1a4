// X27 to X29: curves through many keys, and through few or equal ones.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/motion/curve.h"
#include "mv/motion/nodes.h"

using namespace mv;
using namespace mv::test;

namespace {

using Scalars = std::vector<Keyframe<double>>;

double runge(double x) { return 1 / (1 + 25 * x * x); }
double sine(double x) { return std::sin(3 * x); }

std::vector<double> equispaced(int count) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(2.0 * i / (count - 1) - 1);
    return times;
}

Scalars keysOf(double (*motion)(double), const std::vector<double>& times) {
    Scalars keys;
    for (const double time : times) keys.push_back({time, motion(time)});
    return keys;
}

// Lagrange's polynomial as textbooks write it: a product for each key.
template <typename T>
T textbook(const Scalars& keys, double time) {
    T sum = 0;
    for (std::size_t j = 0; j < keys.size(); ++j) {
        T basis = 1;
        for (std::size_t k = 0; k < keys.size(); ++k) {
            if (k == j) continue;
            const T node = T(keys[k].time);
            basis *= (T(time) - node) / (T(keys[j].time) - node);
        }
        sum += basis * T(keys[j].value);
    }
    return sum;
}

// The largest error against the motion at 2001 times between -1 and 1.
double errorOf(double (*motion)(double), const std::function<double(double)>& curve) {
    double worst = 0;
    for (int i = 0; i <= 2000; ++i) {
        const double time = i / 1000.0 - 1;
        worst = worse(worst, std::abs(curve(time) - motion(time)));
    }
    return worst;
}
double errorOf(double (*motion)(double), const Curve<double>& curve) {
    return errorOf(motion, [&](double time) { return curve.position(time); });
}

Row rungeRow(int count, bool isSpline, double tolerance, const std::string& reason) {
    const Scalars even = keysOf(runge, equispaced(count));
    const Scalars chebyshev = keysOf(runge, chebyshevNodes(count, -1, 1));
    const std::string keys = std::to_string(count) + " keys";
    return {
        .id = "X27 " + keys + (isSpline ? " spline" : " Chebyshev"),
        .input = "Runge's motion 1/(1 + 25 t²), t from −1 to 1, " + keys,
        .measured = "largest error between the keys",
        .naive = "one polynomial, keys at equal steps of time",
        .naiveError = errorOf(runge, [&](double time) { return textbook<double>(even, time); }),
        .ours = isSpline ? "Curve::naturalSpline, the same keys" : "Curve::lagrange, keys at chebyshevNodes",
        .ourError = errorOf(runge, isSpline ? Curve<double>::naturalSpline(even) : Curve<double>::lagrange(chebyshev)),
        .tolerance = tolerance,
        .reason = reason};
}
const std::string poles = "the poles at ±i/5: (1/5 + √1.04)^(1 − n) = ";
[[maybe_unused]] const bool x27a = addRow([] { return rungeRow(21, false, 2e-2, poles + "1.9e-2"); });
[[maybe_unused]] const bool x27b = addRow([] { return rungeRow(41, false, 4e-4, poles + "3.5e-4"); });
[[maybe_unused]] const bool x27c = addRow([] { return rungeRow(81, false, 1.5e-7, poles + "1.2e-7"); });
// The bound of de Boor's book for splines with exact ends, which the motion's flat ends nearly have.
const std::string bend = "5/384 h⁴ times the fourth derivative, 15000 in the middle: ";
[[maybe_unused]] const bool x27d = addRow([] { return rungeRow(21, true, 2e-2, bend + "2.0e-2"); });
[[maybe_unused]] const bool x27e = addRow([] { return rungeRow(81, true, 8e-5, bend + "7.6e-5"); });

// How far two forms of one polynomial are from its true values, in its terms without their signs: what rounding of the keys
// alone would cost.
[[maybe_unused]] const bool x27f = addRow([] {
    const Scalars keys = keysOf(runge, equispaced(81));
    const Curve<double> curve = Curve<double>::lagrange(keys);
    std::vector<Wide> weights;
    for (const auto& key : keys) {
        Wide product = 1;
        for (const auto& other : keys) {
            if (other.time != key.time) product *= Wide(key.time) - Wide(other.time);
        }
        weights.push_back(1 / product);
    }
    double naive = 0, ours = 0;
    for (int i = 0; i < 200; ++i) {
        const double time = (i + 0.3) / 100 - 1;  // never a key
        Wide sum = 0, sizes = 0, product = 1;
        double above = 0, below = 0;
        for (std::size_t j = 0; j < keys.size(); ++j) {
            const Wide term = weights[j] / (Wide(time) - Wide(keys[j].time)) * keys[j].value;
            sum += term;
            sizes += abs(term);
            product *= Wide(time) - Wide(keys[j].time);
            const double factor = static_cast<double>(weights[j]) / (time - keys[j].time);
            above += factor * keys[j].value;
            below += factor;
        }
        const auto part = [&](double value) { return static_cast<double>(abs((Wide(value) / product - sum) / sizes)); };
        naive = worse(naive, part(above / below));
        ours = worse(ours, part(curve.position(time)));
    }
    return Row{.id = "X27 81 keys polynomial",
               .input = "the polynomial through Runge's 81 keys at equal steps, that swings by 5e11",
               .measured = "error against its own values, part of its terms without their signs",
               .naive = "the second barycentric form in double",
               .naiveError = naive,
               .ours = "Curve::lagrange: the first",
               .ourError = ours,
               .tolerance = 4.5e-14,
               .reason = "backward stable: 5 (n + 1) roundings of 1.1e-16 (Higham 2004)"};
});

Row sineRow(int count) {
    const Scalars even = keysOf(sine, equispaced(count));
    const std::string keys = std::to_string(count) + " keys";
    return {.id = "X28 " + keys,
            .input = "the smooth motion sin 3t, t from −1 to 1, " + keys,
            .measured = "largest error between the keys",
            .naive = "one polynomial, keys at equal steps of time, in float",
            .naiveError = errorOf(sine, [&](double time) { return double(textbook<float>(even, time)); }),
            .ours = "Curve::lagrange, keys at chebyshevNodes",
            .ourError = errorOf(sine, Curve<double>::lagrange(keysOf(sine, chebyshevNodes(count, -1, 1)))),
            .tolerance = 1e-12,
            .reason = "keys' roundings of 1.1e-16, times 5 (n + 1) and a Lebesgue constant below 4: 1e-13"};
}
[[maybe_unused]] const bool x28a = addRow([] { return sineRow(41); });
[[maybe_unused]] const bool x28b = addRow([] { return sineRow(61); });

// The textbook's recursion (Barry and Goldman 1988) from p[1] to p[2], with knots the roots of the distances apart.
vec3 barryGoldman(const std::vector<vec3>& p, double u) {
    std::vector<double> knots{0};
    for (std::size_t i = 1; i < 4; ++i) knots.push_back(knots[i - 1] + std::sqrt(glm::length(p[i] - p[i - 1])));
    const double t = knots[1] + u * (knots[2] - knots[1]);
    const auto between = [&](const vec3& a, const vec3& b, std::size_t i, std::size_t k) {
        return (knots[k] - t) / (knots[k] - knots[i]) * a + (t - knots[i]) / (knots[k] - knots[i]) * b;
    };
    const vec3 a = between(p[0], p[1], 0, 1), b = between(p[1], p[2], 1, 2), c = between(p[2], p[3], 2, 3);
    return between(between(a, b, 0, 2), between(b, c, 1, 3), 1, 2);
}

[[maybe_unused]] const bool x29a = addRow([] {
    const vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0);
    double naive = 0, ours = 0;
    for (const auto& places : {std::vector{a, b, b, c}, std::vector{a, a, b, c}, std::vector{a, b, c, c}}) {
        std::vector<Keyframe<vec3>> keys;
        for (const vec3& place : places) keys.push_back({static_cast<double>(keys.size()), place});
        const Curve<vec3> curve = Curve<vec3>::catmullRom(keys);
        for (int i = 0; i <= 10; ++i) {
            const vec3 plain = barryGoldman(places, i / 10.0), position = curve.position(1 + i / 10.0);
            naive = worse(naive, allFinite(glm::dmat3(plain, plain, plain)) ? 0 : infinite);
            ours = worse(ours, allFinite(glm::dmat3(position, position, position)) ? 0 : infinite);
        }
        for (const double time : {1.0, 2.0, 3.0}) {
            ours = worse(ours, glm::length(curve.position(time - 1e-12) - curve.position(time)));
        }
    }
    return Row{.id = "X29 equal keys",
               .input = "a centripetal Catmull-Rom curve of four keys, two of which are one place",
               .measured = "the largest jump at a key; infinity for NaN",
               .naive = "Barry and Goldman's recursion",
               .naiveError = naive,
               .ours = "Curve::catmullRom: rests",
               .ourError = ours,
               .tolerance = 1e-11,
               .reason = "what a velocity below 10 moves in 1e-12"};
});

[[maybe_unused]] const bool x29b = addRow([] {
    // The second derivatives of the textbook's natural spline for three keys: one equation.
    const auto plain = [](const Scalars& k) {
        const double h = k[1].time - k[0].time, l = k[2].time - k[1].time;
        return 3 * ((k[2].value - k[1].value) / l - (k[1].value - k[0].value) / h) / (h + l);
    };
    const Scalars twice{{0, 0}, {1, 1}, {1, 2}};
    return Row{.id = "X29 one time",
               .input = "a spline through keys at 0, 1 and 1",
               .measured = "1 where a curve comes out, infinity where it is not finite, 0 where it is refused",
               .naive = "the equation of the middle key",
               .naiveError = std::isfinite(plain(twice)) ? 1 : infinite,
               .ours = "Curve::naturalSpline",
               .ourError = accepted([&] { Curve<double>::naturalSpline(twice); }),
               .tolerance = 0,
               .reason = "a time has one value"};
});

[[maybe_unused]] const bool x29c = addRow([] {
    double ours = accepted([] { Curve<double>::naturalSpline({}); });
    for (const double time : {0.0, 0.5, 1.0}) {
        ours = worse(ours, std::abs(Curve<double>::naturalSpline({{0, 3}}).position(time) - 3));
        ours = worse(ours, std::abs(Curve<double>::naturalSpline({{0, 3}, {1, 5}}).position(time) - (3 + 2 * time)));
        ours = worse(ours, std::abs(Curve<double>::lagrange({{0, 3}}).position(time) - 3));
    }
    // One key: no span to divide by.
    const double first = 0, last = 0, u = (0.5 - first) / (last - first);
    return Row{.id = "X29 few keys",
               .input = "two keys, one and none",
               .measured = "error against the line, the constant, and a refusal",
               .naive = "(1 − u) p + u q with u = (t − first)/(last − first)",
               .naiveError = worse(0, (1 - u) * 3 + u * 3 - 3),
               .ours = "Curve::naturalSpline, Curve::lagrange",
               .ourError = ours,
               .tolerance = 1e-15,
               .reason = "roundings of a 5"};
});

}  // namespace
