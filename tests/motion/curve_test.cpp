#include "mv/motion/curve.h"

#include <algorithm>
#include <array>
#include <vector>

#include "math/support.h"
#include "mv/math/require.h"
#include "mv/motion/nodes.h"

using namespace mv;
using namespace mv::test;

namespace {

using Keys = std::vector<Keyframe<vec3>>;
using Scalars = std::vector<Keyframe<double>>;

// Keys at uneven times, in a cube of size 2.
Keys randomKeys(int count, bool isClosed = false, std::uint64_t seed = 3) {
    Random random(seed);
    Keys keys;
    double time = -1;
    for (int i = 0; i < count; ++i) {
        keys.push_back({time, random.point(1)});
        time += random.number(0.3, 1);
    }
    if (isClosed) keys.back().value = keys.front().value;
    return keys;
}

struct Kind {
    std::string name;
    std::function<Curve<vec3>(const Keys&)> make;
    bool passesThrough, isClosed;
    int smoothness;  // how many derivatives are continuous at the keys, at any times
};

const std::vector<Kind>& kinds() {
    using C = Curve<vec3>;
    const auto catmullRom = [](Knots knots, Ends ends) {
        return [=](const Keys& keys) { return C::catmullRom(keys, knots, ends); };
    };
    static const std::vector<Kind> list{
        {"linear", [](const Keys& keys) { return C::linear(keys); }, true, false, 0},
        {"linear closed", [](const Keys& keys) { return C::linear(keys, Ends::closed); }, true, true, 0},
        {"lagrange", C::lagrange, true, false, 2},
        {"natural", C::naturalSpline, true, false, 2},
        {"clamped", [](const Keys& keys) { return C::clampedSpline(keys, vec3(1, 2, 3), vec3(-1)); }, true, false, 2},
        {"periodic", C::periodicSpline, true, true, 2},
        {"uniform", catmullRom(Knots::uniform, Ends::open), true, false, 0},
        {"uniform closed", catmullRom(Knots::uniform, Ends::closed), true, true, 0},
        {"centripetal", catmullRom(Knots::centripetal, Ends::open), true, false, 0},
        {"centripetal closed", catmullRom(Knots::centripetal, Ends::closed), true, true, 0},
        {"times", catmullRom(Knots::times, Ends::open), true, false, 1},
        {"times closed", catmullRom(Knots::times, Ends::closed), true, true, 1},
        {"bSpline", [](const Keys& keys) { return C::bSpline(keys); }, false, false, 0},
        {"bSpline closed", [](const Keys& keys) { return C::bSpline(keys, Ends::closed); }, false, true, 0},
        {"bezier", C::bezier, false, false, 2}};
    return list;
}

double size(const vec3& v) { return glm::length(v); }

// The largest jumps of position, velocity and acceleration at the keys (of a closed curve at its seam, too). The change within a
// span of 1e-9 is below 1e-6 for the curves here.
std::array<double, 3> jumps(const Curve<vec3>& curve) {
    std::array<double, 3> largest{};
    for (const double time : curve.breaks()) {
        const bool isEnd = time == curve.start() || time == curve.end();
        if (isEnd && !curve.isClosed()) continue;
        const auto before = curve.at(time - 1e-9), after = curve.at(time);
        largest[0] = std::max(largest[0], size(after.position - before.position));
        largest[1] = std::max(largest[1], size(after.velocity - before.velocity));
        largest[2] = std::max(largest[2], size(after.acceleration - before.acceleration));
    }
    return largest;
}

TEST(Curve, HasTheValuesOfItsKeysExactly) {
    for (const Kind& kind : kinds()) {
        const Keys keys = randomKeys(9, kind.isClosed);
        const auto curve = kind.make(keys);
        for (const Keyframe<vec3>& key : keys) {
            const bool isEnd = (key.time == keys.front().time || key.time == keys.back().time) && !kind.isClosed;
            if (!kind.passesThrough && !isEnd) continue;
            EXPECT_EQ(curve.position(key.time), key.value) << kind.name << " at " << key.time;
            EXPECT_EQ(curve.at(key.time).position, key.value) << kind.name << " at " << key.time;
        }
        EXPECT_EQ(curve.start(), keys.front().time);
        EXPECT_EQ(curve.end(), keys.back().time);
    }
    // A case in which p + u (q - p) with u = 1 is 0.
    EXPECT_EQ(Curve<double>::linear({{0, 1e20}, {1, 1}}).position(1), 1);
    EXPECT_GT(size(Curve<vec3>::bSpline(randomKeys(9)).position(randomKeys(9)[4].time) - randomKeys(9)[4].value), 0.1);
}

TEST(Curve, DerivativesAreTheDifferencesOfPositions) {
    for (const Kind& kind : kinds()) {
        const Keys keys = randomKeys(7, kind.isClosed);
        const auto curve = kind.make(keys);
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
            for (const double u : {0.1, 0.5, 0.83}) {
                const double t = keys[i].time + u * (keys[i + 1].time - keys[i].time), h = 5e-3;
                const auto p = [&](double steps) { return curve.position(t + steps * h); };
                const vec3 velocity = (45.0 * (p(1) - p(-1)) - 9.0 * (p(2) - p(-2)) + (p(3) - p(-3))) / (60 * h);
                const vec3 acceleration =
                    (270.0 * (p(1) + p(-1)) - 27.0 * (p(2) + p(-2)) + 2.0 * (p(3) + p(-3)) - 490.0 * p(0)) /
                    (180 * h * h);
                const CurvePoint<vec3> point = curve.at(t);
                EXPECT_EQ(point.position, curve.position(t));
                // Exact but for h^6 times derivatives of order 7, which only lagrange and bezier, of degree 6, have not
                // either: so roundings of positions up to 10, over h and h^2.
                EXPECT_LT(size(point.velocity - velocity), 1e-11) << kind.name << " at " << t;
                EXPECT_LT(size(point.acceleration - acceleration), 5e-9) << kind.name << " at " << t;
            }
        }
    }
}

TEST(Curve, IsAsSmoothAsItSays) {
    for (const Kind& kind : kinds()) {
        const auto found = jumps(kind.make(randomKeys(9, kind.isClosed)));
        EXPECT_LT(found[0], 1e-6) << kind.name;
        const bool isC1 = found[1] < 1e-6, isC2 = isC1 && found[2] < 1e-5;
        EXPECT_EQ(isC1, kind.smoothness >= 1) << kind.name << ": " << found[1];
        EXPECT_EQ(isC2, kind.smoothness >= 2) << kind.name << ": " << found[2];
    }
}

TEST(Curve, EvenTimesMakeUniformCurvesSmooth) {
    for (const bool isClosed : {false, true}) {
        Keys keys = randomKeys(9, isClosed);
        for (std::size_t i = 0; i < keys.size(); ++i) keys[i].time = static_cast<double>(i);
        const Ends ends = isClosed ? Ends::closed : Ends::open;
        const auto uniform = jumps(Curve<vec3>::catmullRom(keys, Knots::uniform, ends));
        EXPECT_LT(uniform[1], 1e-6);
        EXPECT_GT(uniform[2], 0.1);  // once, not twice
        const auto spline = jumps(Curve<vec3>::bSpline(keys, ends));
        EXPECT_LT(spline[1], 1e-6);
        EXPECT_LT(spline[2], 1e-6);
        // Times that are spread as the knots are: centripetal is smooth, too.
        for (std::size_t i = 1; i < keys.size(); ++i) {
            keys[i].time = keys[i - 1].time + std::sqrt(size(keys[i].value - keys[i - 1].value));
        }
        const auto centripetal = jumps(Curve<vec3>::catmullRom(keys, Knots::centripetal, ends));
        EXPECT_LT(centripetal[1], 1e-6);
        EXPECT_GT(centripetal[2], 0.1);
    }
}

TEST(Curve, CentripetalKeepsTheDirectionAtItsKeys) {
    const Keys keys = randomKeys(9);
    const auto curve = Curve<vec3>::catmullRom(keys);
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
        const vec3 before = curve.at(keys[i].time - 1e-9).velocity, after = curve.at(keys[i].time).velocity;
        EXPECT_LT(size(glm::normalize(before) - glm::normalize(after)), 1e-6);
    }
}

TEST(Curve, ClosedOnesGoOnPastTheirEnds) {
    for (const Kind& kind : kinds()) {
        if (!kind.isClosed) continue;
        const Keys keys = randomKeys(8, true);
        const auto curve = kind.make(keys);
        const double period = curve.end() - curve.start();
        for (const double u : {0.0, 0.3, 0.99}) {
            const double t = curve.start() + u * period;
            for (const int laps : {-2, 1, 7}) {
                // Times up to 40 have roundings of 4e-15, and velocities are some 5.
                EXPECT_LT(size(curve.position(t + laps * period) - curve.position(t)), 1e-13) << kind.name;
            }
        }
        EXPECT_TRUE(isFinite(curve.at(1e300).position) && isFinite(curve.at(-1e300).position));
    }
}

TEST(Curve, ClosedOnesAreTheSameWhereverTheyBegin) {
    for (const Kind& kind : kinds()) {
        if (!kind.isClosed) continue;
        const Keys keys = randomKeys(8, true);
        const double period = keys.back().time - keys.front().time;
        Keys later(keys.begin() + 3, keys.end());
        for (std::size_t i = 1; i < 4; ++i) later.push_back({keys[i].time + period, keys[i].value});
        const auto curve = kind.make(keys), other = kind.make(later);
        for (int i = 0; i < 40; ++i) {
            const double t = curve.start() + (i + 0.5) / 40 * period;
            // Roundings of times up to 8 and of positions over spans of 0.3.
            EXPECT_LT(size(curve.position(t) - other.position(t)), 1e-13) << kind.name;
            EXPECT_LT(size(curve.at(t).velocity - other.at(t).velocity), 1e-12) << kind.name;
        }
        // The value that jumps at the seam is that of the span which begins there.
        EXPECT_EQ(curve.at(curve.end()).velocity, curve.at(curve.start()).velocity) << kind.name;
        EXPECT_EQ(curve.at(curve.end()).acceleration, curve.at(curve.start()).acceleration) << kind.name;
    }
}

TEST(Curve, IsAffinelyInvariant) {
    Random random(5);
    const mat3 turn(random.point(2), random.point(2), random.point(2));
    const vec3 shift = random.point(10);
    for (const Kind& kind : kinds()) {
        // The knots of centripetal curves are distances, which only turning, moving and scaling keeps in proportion. The
        // clamped one's velocities are in the test, not in the keys.
        if (kind.name.rfind("centripetal", 0) == 0 || kind.name == "clamped") continue;
        const Keys keys = randomKeys(8, kind.isClosed);
        Keys moved = keys;
        for (Keyframe<vec3>& key : moved) key.value = turn * key.value + shift;
        const auto curve = kind.make(keys), other = kind.make(moved);
        for (int i = 0; i <= 40; ++i) {
            const double t = i == 40 ? curve.end() : curve.start() + i / 40.0 * (curve.end() - curve.start());
            // Roundings of coordinates up to 20 in sums whose terms are up to 10 times as large.
            EXPECT_LT(size(turn * curve.position(t) + shift - other.position(t)), 2e-13) << kind.name;
            EXPECT_LT(size(turn * curve.at(t).velocity - other.at(t).velocity), 2e-12) << kind.name;
        }
    }
    const Keys keys = randomKeys(8);
    Keys moved = keys;
    for (Keyframe<vec3>& key : moved) key.value = 7.0 * vec3(key.value.y, key.value.z, key.value.x) + shift;
    const auto curve = Curve<vec3>::catmullRom(keys), other = Curve<vec3>::catmullRom(moved);
    for (int i = 0; i < 40; ++i) {
        const double t = curve.start() + i / 40.0 * (curve.end() - curve.start());
        const vec3 p = curve.position(t);
        EXPECT_LT(size(7.0 * vec3(p.y, p.z, p.x) + shift - other.position(t)), 1e-13);
    }
}

// ---- what each kind is

double cubic(double t) { return 2 * t * t * t - t * t + 3 * t - 5; }
double cubicSlope(double t) { return 6 * t * t - 2 * t + 3; }

TEST(Spline, ClampedFollowsCubics) {
    Scalars keys;
    for (const double t : {-1.0, -0.9, 0.3, 2.0}) keys.push_back({t, cubic(t)});
    const auto curve = Curve<double>::clampedSpline(keys, cubicSlope(-1), cubicSlope(2));
    for (int i = 0; i <= 60; ++i) {
        const double t = i / 20.0 - 1;
        // Numbers up to 20 and a slope over a span of 0.1.
        EXPECT_NEAR(curve.position(t), cubic(t), 1e-14);
        EXPECT_NEAR(curve.at(t).velocity, cubicSlope(t), 2e-13);
        EXPECT_NEAR(curve.at(t).acceleration, 12 * t - 2, 4e-12);
    }
}

TEST(Spline, NaturalHasNoAccelerationAtItsEnds) {
    const Keys keys = randomKeys(6);
    const auto curve = Curve<vec3>::naturalSpline(keys);
    EXPECT_EQ(curve.at(curve.start()).acceleration, vec3(0));
    EXPECT_EQ(curve.at(curve.end()).acceleration, vec3(0));
    EXPECT_GT(size(curve.at(keys[2].time).acceleration), 0.1);
}

TEST(Spline, NaturalBendsLeast) {
    // The natural spline has, of all curves through the keys, the least integral of the acceleration's square (Holladay).
    const Keys keys = randomKeys(7);
    const auto bending = [&](const Curve<vec3>& curve) {
        double sum = 0;
        for (int i = 0; i < 2000; ++i) {
            const vec3 a = curve.at(curve.start() + (i + 0.5) / 2000 * (curve.end() - curve.start())).acceleration;
            sum += glm::dot(a, a);
        }
        return sum;
    };
    const double least = bending(Curve<vec3>::naturalSpline(keys));
    EXPECT_GT(bending(Curve<vec3>::clampedSpline(keys, vec3(1), vec3(0))), least);
    EXPECT_GT(bending(Curve<vec3>::lagrange(keys)), least);
    EXPECT_GT(bending(Curve<vec3>::catmullRom(keys, Knots::times)), least);
}

TEST(Spline, PeriodicOfTwoSpansSolvesItsEquations) {
    // Both neighbours of a key are the other one: 2 M0 + M1 = 6 (slope after - slope before)/(both lengths).
    const auto curve = Curve<double>::periodicSpline({{0, 1}, {1, 3}, {4, 1}});
    const double bend = 6 * (2 + 2.0 / 3) / 4;  // slopes 2 and -2/3; at key 1 the same with the other sign
    EXPECT_NEAR(curve.at(0).acceleration, bend, 1e-15);
    EXPECT_NEAR(curve.at(1).acceleration, -bend, 1e-15);
}

TEST(CatmullRom, HasTheTextbooksTangents) {
    const Keys keys = randomKeys(5);
    const auto curve = Curve<vec3>::catmullRom(keys, Knots::uniform);
    const double length = keys[3].time - keys[2].time;
    EXPECT_LT(size(curve.at(keys[2].time).velocity * length - (keys[3].value - keys[1].value) / 2.0), 1e-14);
    // Parabolas are followed to the very ends.
    Scalars parabola;
    for (const double t : {0.0, 1.0, 3.0, 3.5}) parabola.push_back({t, t * t - t});
    const auto followed = Curve<double>::catmullRom(parabola, Knots::times);
    for (int i = 0; i <= 35; ++i) EXPECT_NEAR(followed.position(i / 10.0), i / 10.0 * (i / 10.0 - 1), 5e-15);
}

TEST(BSpline, StaysInTheHullOfFourKeys) {
    for (const bool isClosed : {false, true}) {
        const Keys keys = randomKeys(9, isClosed);
        const auto curve = Curve<vec3>::bSpline(keys, isClosed ? Ends::closed : Ends::open);
        Random random(7);
        for (int i = 0; i < 2000; ++i) {
            const double t = random.number(curve.start(), curve.end());
            std::size_t span = 0;
            while (keys[span + 1].time <= t) ++span;
            // On no side of any plane beyond all of them. The key before the first of a closed curve is the last but one.
            const vec3 normal = random.direction();
            double most = -infinite;
            for (int k = -1; k <= 2; ++k) {
                const int last = static_cast<int>(keys.size()) - 1, at = static_cast<int>(span) + k;
                const int index = isClosed ? (at + last) % last : std::clamp(at, 0, last);
                most = std::max(most, glm::dot(normal, keys[static_cast<std::size_t>(index)].value));
            }
            EXPECT_LE(glm::dot(normal, curve.position(t)), most + 1e-15);
        }
    }
}

TEST(Bezier, IsTheSumOfBernsteinPolynomials) {
    const Keys keys = randomKeys(11);
    const auto curve = Curve<vec3>::bezier(keys);
    for (int i = 0; i <= 50; ++i) {
        const double u = i / 50.0, v = 1 - u;
        vec3 sum(0);
        double binomial = 1;
        for (int k = 0; k <= 10; ++k) {
            sum += binomial * std::pow(u, k) * std::pow(v, 10 - k) * keys[static_cast<std::size_t>(k)].value;
            binomial *= (10.0 - k) / (k + 1);
        }
        // Positive terms that add up to at most 1 in size.
        const double t = i == 50 ? curve.end() : curve.start() + u * (curve.end() - curve.start());
        EXPECT_LT(size(curve.position(t) - sum), 4e-15);
    }
    EXPECT_EQ(Curve<double>::bezier({{0, 1}, {2, 5}}).at(1).velocity, 2);
    EXPECT_EQ(Curve<double>::bezier({{0, 0}, {1, 0}, {2, 4}}).at(1).acceleration, 2);
}

TEST(Lagrange, FollowsPolynomials) {
    Scalars keys;
    for (const double t : {-1.0, 0.5, 0.75, 3.0}) keys.push_back({t, cubic(t)});
    const auto curve = Curve<double>::lagrange(keys);
    for (int i = 0; i <= 40; ++i) {
        const double t = i / 10.0 - 1;
        // Values up to 50, velocities over a gap of 0.25.
        EXPECT_NEAR(curve.position(t), cubic(t), 2e-13);
        EXPECT_NEAR(curve.at(t).velocity, cubicSlope(t), 2e-12);
        EXPECT_NEAR(curve.at(t).acceleration, 12 * t - 2, 2e-11);
    }
}

TEST(Lagrange, IsExactNextToItsNodes) {
    const auto curve = Curve<double>::lagrange({{-1, 2}, {0, 1}, {1, 5}});
    for (const double t : {0x1p-1074, 1e-300, -1e-300, 1e-20}) {
        EXPECT_EQ(curve.position(t), 1);
        EXPECT_NEAR(curve.at(t).velocity, 1.5, 1e-15);
        EXPECT_NEAR(curve.at(t).acceleration, 5, 1e-14);
    }
    EXPECT_NEAR(curve.position(1 - 0x1p-53), 5, 2e-15);
}

TEST(Lagrange, HoldsTwoHundredNodes) {
    for (const double range : {1e-100, 1.0, 1e100}) {
        Scalars keys;
        for (const double t : chebyshevNodes(200, -range, range)) keys.push_back({t, std::sin(3 * t / range)});
        const auto curve = Curve<double>::lagrange(keys);
        // Chebyshev nodes carry roundings on by their Lebesgue constant, 4.4.
        for (int i = 0; i <= 100; ++i) {
            const double x = i / 50.0 - 1;
            EXPECT_NEAR(curve.position(x * range), std::sin(3 * x), 2e-14);
        }
    }
    Scalars even;
    for (int i = 0; i < 200; ++i) even.push_back({i * 0.01, 1});
    // Sums of 1 and -1 times 1e56: what comes out is no 1, but a number of that size times a rounding, as of any method.
    const auto curve = Curve<double>::lagrange(even);
    EXPECT_LT(std::abs(curve.position(0.005)), 1e43);
    EXPECT_NEAR(curve.position(1.005), 1, 1e-13);  // in the middle no digit is in danger
}

// ---- how the error falls

// The slope of the error against the distance of the keys, from n to 2 n spans of a smooth motion.
double order(const std::function<Curve<double>(const Scalars&)>& make, int n, bool isInside) {
    const auto error = [&](int spans) {
        Scalars keys;
        for (int i = 0; i <= spans; ++i) keys.push_back({2.0 * i / spans - 1, std::sin(3 * (2.0 * i / spans - 1))});
        const auto curve = make(keys);
        double worst = 0;
        for (int i = 0; i <= 5000; ++i) {
            const double t = (i / 2500.0 - 1) * (isInside ? 0.5 : 1);
            worst = std::max(worst, std::abs(curve.position(t) - std::sin(3 * t)));
        }
        return worst;
    };
    return std::log2(error(n) / error(2 * n));
}

TEST(Curve, ErrorsFallAsTheySay) {
    using C = Curve<double>;
    const double slope = 3 * std::cos(3.0);
    const auto clamped = [&](const Scalars& keys) { return C::clampedSpline(keys, slope, slope); };
    const auto catmullRom = [](const Scalars& keys) { return C::catmullRom(keys, Knots::uniform); };
    // From 40 keys on, the next terms of the error are less than a tenth.
    EXPECT_NEAR(order([](const Scalars& keys) { return C::linear(keys); }, 40, false), 2, 0.1);
    EXPECT_NEAR(order(clamped, 40, false), 4, 0.1);
    EXPECT_NEAR(order(C::naturalSpline, 40, true), 4, 0.1);   // away from the ends
    EXPECT_NEAR(order(C::naturalSpline, 40, false), 2, 0.1);  // at the ends the acceleration is wrong
    EXPECT_NEAR(order(catmullRom, 40, false), 3, 0.1);
}

// ---- extremes

TEST(CurveExtremes, X29OneKeyIsAConstant) {
    for (const Kind& kind : kinds()) {
        if (kind.name == "clamped") continue;
        const auto curve = kind.make({{2, {1, 2, 3}}});
        for (const double t : {-1e300, 2.0, 5.0}) {
            EXPECT_EQ(curve.position(t), vec3(1, 2, 3)) << kind.name;
            EXPECT_EQ(curve.at(t).velocity, vec3(0)) << kind.name;
            EXPECT_EQ(curve.at(t).acceleration, vec3(0)) << kind.name;
        }
        EXPECT_EQ(curve.start(), curve.end());
    }
}

TEST(CurveExtremes, X29TwoKeysAreALine) {
    const Keys keys{{1, {0, 0, 0}}, {3, {2, 4, -6}}};
    for (const Kind& kind : kinds()) {
        if (kind.name == "clamped" || kind.isClosed) continue;
        const CurvePoint<vec3> point = kind.make(keys).at(1.5);
        EXPECT_LT(size(point.position - vec3(0.5, 1, -1.5)), 1e-15) << kind.name;
        EXPECT_LT(size(point.velocity - vec3(1, 2, -3)), 1e-15) << kind.name;
        EXPECT_LT(size(point.acceleration), 1e-14) << kind.name;
    }
    // The two keys of a closed curve are the same one.
    for (const Kind& kind : kinds()) {
        if (!kind.isClosed) continue;
        EXPECT_EQ(kind.make({{0, vec3(1)}, {2, vec3(1)}}).position(0.7), vec3(1)) << kind.name;
    }
}

TEST(CurveExtremes, X29EqualValuesAreNoError) {
    const vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0);
    for (const Kind& kind : kinds()) {
        for (const std::vector<vec3>& places :
             {std::vector<vec3>{a, a, b, c, a}, {a, b, b, b, c, a}, {a, b, a, a}, {a, a, a, a}}) {
            Keys keys;
            for (const vec3& place : places) keys.push_back({static_cast<double>(keys.size()), place});
            const auto curve = kind.make(keys);
            for (int i = 0; i <= 100; ++i) {
                const double t = i / 100.0 * curve.end();
                EXPECT_LT(size(curve.at(t).position), kind.name == "clamped" ? 4 : 2.5) << kind.name;  // false for NaN
                EXPECT_LT(size(curve.at(t).velocity), 10) << kind.name;
            }
            EXPECT_LT(jumps(curve)[0], 1e-6) << kind.name;
        }
    }
    // A centripetal one rests between them, and its path is as if the key had been given once.
    const auto rests = Curve<vec3>::catmullRom({{0, a}, {1, b}, {2, b}, {3, c}});
    const auto once = Curve<vec3>::catmullRom({{0, a}, {1, b}, {2, c}});
    EXPECT_EQ(rests.at(1.5).velocity, vec3(0));
    EXPECT_EQ(rests.position(1.5), b);
    EXPECT_EQ(rests.position(2.25), once.position(1.25));
    // And nearly equal ones.
    for (const double off : {0x1p-1074, 1e-300, 1e-16}) {
        const auto curve = Curve<vec3>::catmullRom({{0, a}, {1, {off, 0, 0}}, {2, b}});
        EXPECT_TRUE(isFinite(curve.at(0.5).acceleration) && isFinite(curve.at(1.5).acceleration)) << off;
    }
}

TEST(CurveExtremes, SizesAndTimesFarFromOne) {
    for (const Kind& kind : kinds()) {
        if (kind.name == "clamped") continue;
        const Keys keys = randomKeys(8, kind.isClosed);
        const auto curve = kind.make(keys);
        for (const double scale : {0x1p-300, 0x1p300}) {
            Keys scaled = keys, stretched = keys;
            for (Keyframe<vec3>& key : scaled) key.value *= scale;
            for (Keyframe<vec3>& key : stretched) key.time *= scale;
            const auto large = kind.make(scaled), slow = kind.make(stretched);
            for (const double t : {curve.start() + 0.1, 0.5, curve.end() - 0.3}) {
                // Powers of two change no digit.
                EXPECT_EQ(large.position(t), curve.position(t) * scale) << kind.name;
                EXPECT_EQ(slow.position(t * scale), curve.position(t)) << kind.name;
                EXPECT_EQ(slow.at(t * scale).velocity * scale, curve.at(t).velocity) << kind.name;
            }
        }
    }
    // Spans that are 1e12 times as long as their neighbours.
    const auto uneven = Curve<double>::naturalSpline({{0, 0}, {1e-12, 1}, {1, 0}, {1 + 1e-12, 1}, {2, 3}});
    for (int i = 0; i <= 100; ++i) EXPECT_TRUE(std::isfinite(uneven.at(i / 50.0).acceleration));
}

TEST(Curve, RefusalsSayWhatWouldHaveBeenRight) {
    using C = Curve<double>;
    for (const Kind& kind : kinds()) {
        EXPECT_NE(refusal([&] { kind.make({}); }).find(": there must be one key at least, 0 keys"), std::string::npos);
        EXPECT_NE(refusal([&] {
                      kind.make({{0, vec3(0)}, {0.5, vec3(1)}, {0.5, vec3(0)}});
                  }).find(": times must increase from key to key, 0.5 after 0.5"),
                  std::string::npos)
            << kind.name;
        EXPECT_NE(refusal([&] {
                      kind.make({{0, vec3(0, notANumber, 0)}});
                  }).find(": the value of a key must be finite, (0, nan, 0)"),
                  std::string::npos);
        EXPECT_NE(refusal([&] {
                      kind.make({{-1e308, vec3(0)}, {1e308, vec3(0)}});
                  }).find(": the time from the first key to the last must be finite, inf"),
                  std::string::npos);
        const Keys large{{0, vec3(1e308)}, {1, vec3(-1e308)}, {2, vec3(1e308)}};
        EXPECT_NE(refusal([&] {
                      kind.make(large).at(0.1);
                  }).find("the keys must not be so large, or so close in time, that the curve overflows"),
                  std::string::npos)
            << kind.name;
    }
    EXPECT_EQ(refusal([] { C::linear({{0, 1}, {1, 2}}).position(1.5); }), "Curve: the time must be 0 to 1, 1.5");
    EXPECT_EQ(refusal([] { C::linear({{0, 1}, {1, 2}}).at(notANumber); }), "Curve: the time must be finite, nan");
    EXPECT_EQ(refusal([] { C::bezier({{0, 1}}).position(infinite); }), "Curve: the time must be finite, inf");
    EXPECT_EQ(refusal([] {
                  C::bSpline({{0, 1}, {1, 2}}, Ends::closed);
              }),
              "Curve::bSpline: the last key of a closed curve must have the value of the first, 1, 2");
    EXPECT_EQ(refusal([] {
                  C::clampedSpline({{0, 1}}, 0, 1);
              }),
              "Curve::clampedSpline: there must be two keys at least, 1 key");
    EXPECT_EQ(refusal([] {
                  C::clampedSpline({{0, 1}, {1, 1}}, infinite, 1);
              }),
              "Curve::clampedSpline: the velocity at the start must be finite, inf");
    Scalars uneven;
    for (int i = 0; i < 40; ++i) uneven.push_back({std::ldexp(1.0, -10 * i), 0});
    std::ranges::reverse(uneven);
    EXPECT_EQ(refusal([&] { C::lagrange(uneven); }).rfind("Curve::lagrange: the times must not be so uneven", 0), 0u);
}

}  // namespace
