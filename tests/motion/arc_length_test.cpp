#include "mv/motion/arc_length.h"

#include "math/support.h"
#include "mv/motion/gauss.h"

using namespace mv;
using namespace mv::test;

namespace {

using Keys = std::vector<Keyframe<vec3>>;

// y = x^2 from 0 to 1 as a Bezier curve; its length is (2 sqrt 5 + asinh 2)/4.
Curve<vec3> parabola() { return Curve<vec3>::bezier({{0, {0, 0, 0}}, {1, {0.5, 0, 0}}, {2, {1, 1, 0}}}); }
const double parabolaLength = (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4;

// A Bezier curve with a cusp: x = 4 w^3, y = 3 w^2 for w = -1/3 .. 2/3, so that no halving of the times 0 .. 3 ends there.
// Its speed |6 w| sqrt(1 + 4 w^2) has the integral ((1 + 4 w^2)^(3/2) - 1)/2 from the cusp to either end.
Curve<vec3> cusp() {
    return Curve<vec3>::bezier({{0, {-4 / 27.0, 1 / 3.0, 0}},
                                {1, {8 / 27.0, -1 / 3.0, 0}},
                                {2, {-16 / 27.0, 0, 0}},
                                {3, {32 / 27.0, 4 / 3.0, 0}}});
}
const double cuspLength = (std::pow(13 / 9.0, 1.5) + std::pow(25 / 9.0, 1.5)) / 2 - 1;

Curve<vec3> circle(int count) {
    Keys keys;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2 * pi * (i % count) / count;
        keys.push_back({static_cast<double>(i), {std::cos(angle), std::sin(angle), 0}});
    }
    return Curve<vec3>::periodicSpline(keys);
}

TEST(ArcLength, IsThatOfKnownCurves) {
    for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
        EXPECT_NEAR(ArcLength(parabola(), tolerance).length() / parabolaLength, 1, tolerance);
        EXPECT_NEAR(ArcLength(cusp(), tolerance).length() / cuspLength, 1, tolerance);
    }
    // A spline's circle: its error is that of the spline, (2 pi/n)^4/720 or so of the radius, and falls with its order.
    const auto off = [](int count) { return std::abs(ArcLength(circle(count)).length() - 2 * pi); };
    EXPECT_LT(off(64), 2 * pi * std::pow(2 * pi / 64, 4) / 100);
    EXPECT_NEAR(std::log2(off(32) / off(64)), 4, 0.1);
}

TEST(ArcLength, AddsUpAndNeverFalls) {
    for (const auto& curve : {parabola(), cusp(), circle(9)}) {
        const ArcLength way(curve);
        double before = 0;
        for (int i = 0; i <= 3000; ++i) {
            const double time = i == 3000 ? curve.end() : curve.start() + i / 3000.0 * (curve.end() - curve.start());
            const double here = way.lengthAt(time);
            EXPECT_GE(here, before);
            before = here;
        }
        EXPECT_EQ(way.lengthAt(curve.start()), 0);
        EXPECT_EQ(way.lengthAt(curve.end()), way.length());
    }
    // The parabola's way up to x, t being 2x.
    const ArcLength way(parabola());
    for (const double x : {1e-9, 0.2, 0.7}) {
        const double truth = (2 * x * std::sqrt(1 + 4 * x * x) + std::asinh(2 * x)) / 4;
        EXPECT_NEAR(way.lengthAt(2 * x) / truth, 1, 1e-12);  // the tolerance
    }
}

TEST(ArcLength, TimeIsTheInverse) {
    Random random(4);
    for (const auto& curve : {parabola(), cusp(), circle(9)}) {
        const ArcLength way(curve);
        double before = curve.start();
        for (int i = 0; i <= 1000; ++i) {
            const double length = i / 1000.0 * way.length(), time = way.timeAt(length);
            EXPECT_NEAR(way.lengthAt(time), length, 1e-14 * way.length()) << i;  // what the header promises
            EXPECT_GE(time, before) << i;
            before = time;
        }
        EXPECT_EQ(way.timeAt(0), curve.start());
        EXPECT_EQ(way.timeAt(way.length()), curve.end());
        const double little = 1e-30 * way.length();
        EXPECT_NEAR(way.lengthAt(way.timeAt(little) - curve.start()), little, 1e-13 * little);
    }
}

TEST(ArcLength, TimeIsFoundWhereNewtonsStepLeavesTheCurve) {
    // From rest, x = t^3: after a millionth of the way the speed at a millionth of the time is 3e-12.
    const ArcLength way(Curve<vec3>::bezier({{0, vec3(0)}, {1 / 3.0, vec3(0)}, {2 / 3.0, vec3(0)}, {1, {1, 0, 0}}}));
    for (const double length : {1e-30, 1e-6, 0.13}) {
        EXPECT_NEAR(way.timeAt(length) / std::cbrt(length), 1, 1e-13) << length;  // a third of 1e-14, and the tolerance
    }
}

TEST(ArcLength, MakesASpeedEqual) {
    // Chords of equal steps of the way are equal but for their curvature: h^2/24 of it, squared.
    const auto curve = parabola();
    const ArcLength way(curve);
    const int count = 1000;
    const double step = way.length() / count;
    double least = infinite, most = 0, leastByTime = infinite, mostByTime = 0;
    for (int i = 0; i < count; ++i) {
        const double first = way.timeAt(i * step), second = way.timeAt(std::min((i + 1) * step, way.length()));
        const double chord = glm::length(curve.position(second) - curve.position(first));
        least = std::min(least, chord / step);
        most = std::max(most, chord / step);
        const double byTime =
            glm::length(curve.position(2.0 * (i + 1) / count) - curve.position(2.0 * i / count)) / step;
        leastByTime = std::min(leastByTime, byTime);
        mostByTime = std::max(mostByTime, byTime);
    }
    EXPECT_LE(most, 1 + 1e-11);                          // 1e-14 of the length, over a step of 1e-3 of it
    EXPECT_GE(least, 1 - 4 * step * step / 24 - 1e-11);  // the curvature is 2 at most
    EXPECT_GT(mostByTime / leastByTime, 2.2);            // speeds 1 to sqrt 5
}

TEST(ArcLength, PlainFormsHaveTheirOrders) {
    const auto order = [](auto form, int n) {
        return std::log2(std::abs(form(n) - parabolaLength) / std::abs(form(2 * n) - parabolaLength));
    };
    EXPECT_NEAR(order([](int n) { return arcLengthByChords(parabola(), n); }, 50), 2, 0.05);
    EXPECT_NEAR(order([](int n) { return arcLengthBySimpson(parabola(), n); }, 20), 4, 0.1);
    EXPECT_LT(arcLengthByChords(parabola(), 100), parabolaLength);
    EXPECT_NEAR(arcLengthByGauss(parabola(), 20), parabolaLength, 1e-10);
    EXPECT_GT(std::abs(arcLengthByGauss(parabola(), 3) - parabolaLength), 1e-6);
    // At the cusp the speed has a kink, and fixed rules are far off.
    EXPECT_GT(std::abs(arcLengthByGauss(cusp(), 15) - cuspLength), 1e-5);
    // Per span: a square is exact with one node a side.
    const Keys square{{0, {0, 0, 0}}, {1, {1, 0, 0}}, {3, {1, 1, 0}}, {4, {0, 1, 0}}, {5, {0, 0, 0}}};
    EXPECT_NEAR(arcLengthByGauss(Curve<vec3>::linear(square), 1), 4, 1e-15);
}

TEST(ArcLengthExtremes, RestsAndEqualPoints) {
    // A rest in the middle: times within it are passed over.
    const auto curve =
        Curve<vec3>::catmullRom({{0, {0, 0, 0}}, {1, {1, 0, 0}}, {2, {1, 0, 0}}, {3, {3, 0, 0}}, {4, {3, 0, 0}}});
    const ArcLength way(curve);
    EXPECT_NEAR(way.length(), 3, 3e-12);
    EXPECT_EQ(way.lengthAt(1), way.lengthAt(2));
    EXPECT_EQ(way.timeAt(way.lengthAt(1.5)), 1);
    EXPECT_GT(way.timeAt(1.000001), 2);
    EXPECT_EQ(way.timeAt(way.length()), 3);  // before the end of the curve, 4
    // No way at all.
    for (const auto& still : {Curve<vec3>::linear({{0, vec3(1)}}), Curve<vec3>::linear({{0, vec3(1)}, {1, vec3(1)}})}) {
        EXPECT_EQ(ArcLength(still).length(), 0);
        EXPECT_EQ(ArcLength(still).lengthAt(still.end()), 0);
        EXPECT_EQ(ArcLength(still).timeAt(0), 0);
        EXPECT_EQ(arcLengthByChords(still, 10), 0);
        EXPECT_EQ(arcLengthBySimpson(still, 10), 0);
        EXPECT_EQ(arcLengthByGauss(still, 10), 0);
    }
}

TEST(ArcLengthExtremes, SizesFarFromOne) {
    for (const double scale : {0x1p-500, 0x1p500}) {
        const auto curve = Curve<vec3>::bezier({{0, {0, 0, 0}}, {1, {0.5 * scale, 0, 0}}, {2, {scale, scale, 0}}});
        const ArcLength way(curve);
        EXPECT_NEAR(way.length() / scale, parabolaLength, 1e-12);
        EXPECT_NEAR(way.timeAt(0.5 * scale), ArcLength(parabola()).timeAt(0.5), 1e-13);
    }
    // A jerk in a thousandth of the time has nearly all of the way.
    const auto jerk =
        Curve<vec3>::linear({{0, {0, 0, 0}}, {1, {1e-9, 0, 0}}, {1.000001, {1e9, 0, 0}}, {2, {1e9, 1e-9, 0}}});
    EXPECT_NEAR(ArcLength(jerk).length(), 1e9, 1e-3);
    EXPECT_NEAR(ArcLength(jerk).lengthAt(0.5), 5e-10, 1e-22);
}

TEST(ArcLength, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] { ArcLength(parabola(), 0); }), "ArcLength: the tolerance must be 1e-13 to 0.1, 0");
    EXPECT_EQ(refusal([] { (void)ArcLength(parabola()).lengthAt(2.5); }),
              "ArcLength::lengthAt: the time must be 0 to 2, 2.5");
    EXPECT_EQ(refusal([] {
                  (void)ArcLength(parabola()).timeAt(notANumber);
              }).rfind("ArcLength::timeAt: the way must be 0 to 1.4", 0),
              0u);
    EXPECT_EQ(refusal([] { arcLengthByChords(parabola(), 0); }), "arcLengthByChords: count must be 1 to 10000000, 0");
    EXPECT_EQ(refusal([] { arcLengthBySimpson(parabola(), 3); }), "arcLengthBySimpson: count must be even, 3");
    EXPECT_EQ(refusal([] { arcLengthByGauss(parabola(), 65); }), "gaussLegendre: count must be 1 to 64, 65");
}

}  // namespace
