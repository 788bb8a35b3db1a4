#include "keyframes/key_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "keyframes/function_nodes.h"

using namespace mv;

namespace {

// All values of an enumeration up to the last.
template <class Enum>
std::vector<Enum> upTo(Enum last) {
    std::vector<Enum> all;
    for (int i = 0; i <= static_cast<int>(last); ++i) all.push_back(static_cast<Enum>(i));
    return all;
}
using Kind = KeyCurve::Kind;
using Ease = KeyCurve::Ease;

const std::vector<Keyframe<vec3>> keys{{0, {1, 2, 0}},    {1, {4, 0, 1}}, {2, {4, 0, 1}},
                                       {3.5, {-2, 5, 3}}, {4, {0, 0, 0}}, {5, {1, 2, 0}}};

}  // namespace

TEST(KeyCurve, isAtItsKeys) {
    for (const Kind kind : upTo(Kind::bezier)) {
        for (const Ease ease : upTo(Ease::steps)) {
            const KeyCurve curve{.kind = kind, .ease = ease};
            const Motion<vec3> motion = curve.through(keys, vec3(0), vec3(0));
            bool isAtAll = true;
            for (const auto& key : keys) isAtAll &= motion.position(key.time) == key.value;
            EXPECT_EQ(isAtAll, kind != Kind::bSpline && kind != Kind::bezier) << int(kind) << " " << int(ease);
        }
    }
}

// By the page's formula: g(t) = (1 - e(u)) g(t0) + e(u) g(t1), with u = (t - t0)/(t1 - t0), and e(u) = u on straight lines.
TEST(KeyCurve, isWhatThePagePrints) {
    const auto check = [](const KeyCurve& curve, const auto& e) {
        EXPECT_EQ(curve.eased(0), 0);
        EXPECT_EQ(curve.eased(1), 1);
        const Motion<vec3> motion = curve.through(keys, vec3(0), vec3(0));
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
            const auto &from = keys[i], &to = keys[i + 1];
            for (const double u : {0.0625, 0.25, 0.5, 0.8125}) {
                const vec3 wanted = (1 - e(u)) * from.value + e(u) * to.value;
                const vec3 is = motion.position(from.time + u * (to.time - from.time));
                EXPECT_NEAR(glm::length(is - wanted), 0, 1e-14) << i << " " << u;  // ten roundings of numbers below 8
            }
        }
    };
    check({.kind = Kind::linear}, [](double u) { return u; });
    check({.kind = Kind::ease, .ease = Ease::root}, [](double u) { return std::sqrt(u); });
    check({.kind = Kind::ease, .ease = Ease::quadratic}, [](double u) { return u * u; });
    // Uniform: the velocity at a key is that from its neighbour before to the one after
    const std::vector<Keyframe<vec3>> even{{0, {1, 2, 0}}, {1, {4, 0, 1}}, {2, {-3, 1, 5}}, {3, {-2, 5, 3}}};
    const Motion<vec3> smooth = KeyCurve{.kind = Kind::catmullRom}.through(even, vec3(0), vec3(0));
    for (const std::size_t i : {1U, 2U})
        EXPECT_NEAR(glm::length(smooth.at(even[i].time).velocity - (even[i + 1].value - even[i - 1].value) / 2.0), 0,
                    1e-14);
}

// Velocities by at() are the differences of places, between the keys and on both sides of them.
TEST(KeyCurve, velocityIsTheSlope) {
    for (const Kind kind : upTo(Kind::bezier)) {
        for (const Ease ease : upTo(Ease::steps)) {
            SCOPED_TRACE(std::to_string(int(kind)) + " " + std::to_string(int(ease)));
            const KeyCurve curve{.kind = kind, .ease = ease};
            const Motion<vec3> motion = curve.through(keys, vec3(0), vec3(0));
            const double step = 1e-5;
            for (const double time : {0.3, 1.7, 2.4, 3.65, 4.9}) {
                const vec3 slope = (motion.position(time + step) - motion.position(time - step)) / (2 * step);
                // The third derivative, below 1e4 here, times step^2/6, and roundings of 1e-15 over the step
                EXPECT_LT(glm::length(motion.at(time).velocity - slope), 1e-6) << time;
            }
        }
    }
}

TEST(KeyCurve, easesEachSpanByItself) {
    KeyCurve curve{.kind = Kind::ease, .ease = Ease::quadratic};
    const Motion<vec3> motion = curve.through(keys, vec3(0), vec3(0));
    EXPECT_EQ(motion.position(0.5), vec3(1.75, 1.5, 0.25));
    EXPECT_EQ(motion.position(1.5), vec3(4, 0, 1)) << "rests between two equal keys";
    EXPECT_NEAR(glm::length(motion.position(2.75) - vec3(2.5, 1.25, 1.5)), 0, 1e-15) << "a span of 1.5";
    EXPECT_EQ(motion.after(0).velocity, vec3(0));
    EXPECT_NEAR(glm::length(motion.before(1).velocity - vec3(6, -4, 2)), 0, 1e-14)
        << "arrives at twice the even velocity";
    // The root's is infinite after a key, but of what rests.
    curve.ease = Ease::root;
    const Motion<vec3> atOnce = curve.through(keys, vec3(0), vec3(0));
    EXPECT_TRUE(std::isinf(atOnce.after(0).velocity.x));
    EXPECT_EQ(atOnce.after(1).velocity, vec3(0));
}

TEST(KeyCurve, jumps) {
    KeyCurve curve;
    const std::vector<double> times{0, 1, 2, 3.5, 4, 5};
    const Jumps straight = jumpsOf(curve.through(keys, vec3(0), vec3(0)), times);
    const vec3 into(2 / 0.5, -5 / 0.5, -3 / 0.5), out(-6 / 1.5, 5 / 1.5, 2 / 1.5);
    EXPECT_NEAR(straight.velocity, glm::length(into - out), 1e-13);
    EXPECT_EQ(straight.acceleration, 0);
    EXPECT_NEAR(straight.end, glm::length(vec3(3, -2, 1)), 1e-13);
    // A closed one has no ends: its first key is one like others.
    curve.kind = Kind::periodic;
    const Jumps closed = jumpsOf(curve.through(keys, vec3(0), vec3(0)), times);
    EXPECT_LT(closed.velocity, 1e-12);
    EXPECT_LT(closed.acceleration, 1e-11);
    EXPECT_EQ(closed.end, 0);
    // One key is at rest.
    curve.kind = Kind::natural;
    const Jumps none = jumpsOf(curve.through<vec3>({{0, vec3(1)}}, vec3(0), vec3(0)), {0});
    EXPECT_EQ(none.velocity + none.acceleration + none.end, 0);
}

TEST(FunctionNodes, haveTheFunctionsValues) {
    for (const auto function : upTo(FunctionNodes::Function::sine)) {
        for (const auto spread : upTo(FunctionNodes::Spread::chebyshev)) {
            for (const int count : {5, 6, 81}) {
                const FunctionNodes of{.function = function, .count = count, .spread = spread};
                const auto nodes = of.keys();
                ASSERT_EQ(nodes.size(), std::size_t(count));
                EXPECT_EQ(nodes.front().time, -1);
                EXPECT_EQ(nodes.back().time, 1);
                for (std::size_t i = 0; i < nodes.size(); ++i) {
                    EXPECT_EQ(nodes[i].value, of.valueAt(nodes[i].time));
                    EXPECT_EQ(nodes[i].time, -nodes[nodes.size() - 1 - i].time) << "symmetrical";
                }
            }
        }
        // The slope: the third derivative, below 3000 for Runge's function, times 1e-10/6
        const FunctionNodes of{.function = function};
        for (const double x : {-0.9, -0.2, 0.0, 0.35, 1.0}) {
            const double difference = (of.valueAt(x + 1e-5) - of.valueAt(x - 1e-5)) / 2e-5;
            EXPECT_NEAR(of.slopeAt(x), difference, 1e-7) << int(function) << " " << x;
        }
    }
}

// All three forms are one polynomial, where there are few nodes: in float to its roundings.
TEST(FunctionNodes, formsAgree) {
    FunctionNodes of{.count = 7};
    const auto right = of.polynomial();
    of.form = FunctionNodes::Form::textbook;
    const auto textbook = of.polynomial();
    of.form = FunctionNodes::Form::inFloat;
    const auto inFloat = of.polynomial();
    for (double x = -1; x <= 1; x += 0.01) {
        EXPECT_NEAR(textbook(x), right(x), 1e-14);  // 7 terms below 5, some 20 roundings of 1.1e-16 each
        EXPECT_NEAR(inFloat(x), right(x), 1e-5);    // the same of 6e-8
    }
}
