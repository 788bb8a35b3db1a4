#include "shared/key_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "shared/function_nodes.h"

using namespace mv;

namespace {

// A demo of knobs alone.
struct Knobs final : Demo {
    KeyCurve by{this};
    FunctionNodes of{this};
    void init() override {}
    void draw(const Frame&) override {}
};

const std::vector<Keyframe<vec3>> keys{{0, {1, 2, 0}},    {1, {4, 0, 1}}, {2, {4, 0, 1}},
                                       {3.5, {-2, 5, 3}}, {4, {0, 0, 0}}, {5, {1, 2, 0}}};

}  // namespace

TEST(KeyCurve, isAtItsKeys) {
    Knobs demo;
    for (const std::string& kind : demo.by.kind.sweep()) {
        demo.by.kind.parse(kind);
        for (const std::string& ease : demo.by.ease.sweep()) {
            demo.by.ease.parse(ease);
            const Motion<vec3> motion = demo.by.through(keys, vec3(0), vec3(0));
            bool isAtAll = true;
            for (const auto& key : keys) isAtAll &= motion.position(key.time) == key.value;
            EXPECT_EQ(isAtAll, kind != "b-spline" && kind != "bezier") << kind << " " << ease;
        }
    }
}

// Velocities by at() are the differences of places, between the keys and on both sides of them.
TEST(KeyCurve, velocityIsTheSlope) {
    Knobs demo;
    for (const std::string& kind : demo.by.kind.sweep()) {
        demo.by.kind.parse(kind);
        for (const std::string& ease : demo.by.ease.sweep()) {
            SCOPED_TRACE(kind + " " + ease);
            demo.by.ease.parse(ease);
            const Motion<vec3> motion = demo.by.through(keys, vec3(0), vec3(0));
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
    Knobs demo;
    demo.by.kind.parse("ease");
    demo.by.ease.parse("quadratic");
    const Motion<vec3> motion = demo.by.through(keys, vec3(0), vec3(0));
    EXPECT_EQ(motion.position(0.5), vec3(1.75, 1.5, 0.25));
    EXPECT_EQ(motion.position(1.5), vec3(4, 0, 1)) << "rests between two equal keys";
    EXPECT_NEAR(glm::length(motion.position(2.75) - vec3(2.5, 1.25, 1.5)), 0, 1e-15) << "a span of 1.5";
    EXPECT_EQ(motion.after(0).velocity, vec3(0));
    EXPECT_NEAR(glm::length(motion.before(1).velocity - vec3(6, -4, 2)), 0, 1e-14)
        << "arrives at twice the even velocity";
    // The root's is infinite after a key, but of what rests.
    demo.by.ease.parse("root");
    EXPECT_TRUE(std::isinf(motion.after(0).velocity.x));
    EXPECT_EQ(motion.after(1).velocity, vec3(0));
}

TEST(KeyCurve, jumps) {
    Knobs demo;
    const std::vector<double> times{0, 1, 2, 3.5, 4, 5};
    const Jumps straight = jumpsOf(demo.by.through(keys, vec3(0), vec3(0)), times);
    const vec3 into(2 / 0.5, -5 / 0.5, -3 / 0.5), out(-6 / 1.5, 5 / 1.5, 2 / 1.5);
    EXPECT_NEAR(straight.velocity, glm::length(into - out), 1e-13);
    EXPECT_EQ(straight.acceleration, 0);
    EXPECT_NEAR(straight.end, glm::length(vec3(3, -2, 1)), 1e-13);
    // A closed one has no ends: its first key is one like others.
    demo.by.kind.parse("periodic");
    const Jumps closed = jumpsOf(demo.by.through(keys, vec3(0), vec3(0)), times);
    EXPECT_LT(closed.velocity, 1e-12);
    EXPECT_LT(closed.acceleration, 1e-11);
    EXPECT_EQ(closed.end, 0);
    // One key is at rest.
    demo.by.kind.parse("natural");
    const Jumps none = jumpsOf(demo.by.through<vec3>({{0, vec3(1)}}, vec3(0), vec3(0)), {0});
    EXPECT_EQ(none.velocity + none.acceleration + none.end, 0);
}

TEST(FunctionNodes, haveTheFunctionsValues) {
    Knobs demo;
    for (const std::string& function : demo.of.function.sweep()) {
        demo.of.function.parse(function);
        for (const std::string& spread : demo.of.spread.sweep()) {
            demo.of.spread.parse(spread);
            for (const char* count : {"5", "6", "81"}) {
                demo.of.count.parse(count);
                const auto nodes = demo.of.keys();
                ASSERT_EQ(std::to_string(nodes.size()), count);
                EXPECT_EQ(nodes.front().time, -1);
                EXPECT_EQ(nodes.back().time, 1);
                for (std::size_t i = 0; i < nodes.size(); ++i) {
                    EXPECT_EQ(nodes[i].value, demo.of.valueAt(nodes[i].time));
                    EXPECT_EQ(nodes[i].time, -nodes[nodes.size() - 1 - i].time) << "symmetrical";
                }
            }
        }
        // The slope: the third derivative, below 3000 for Runge's function, times 1e-10/6
        for (const double x : {-0.9, -0.2, 0.0, 0.35, 1.0}) {
            const double difference = (demo.of.valueAt(x + 1e-5) - demo.of.valueAt(x - 1e-5)) / 2e-5;
            EXPECT_NEAR(demo.of.slopeAt(x), difference, 1e-7) << function << " " << x;
        }
    }
}

// All three forms are one polynomial, where there are few nodes: in float to its roundings.
TEST(FunctionNodes, formsAgree) {
    Knobs demo;
    demo.of.count.parse("7");
    const auto right = demo.of.polynomial();
    demo.of.form.parse("textbook");
    const auto textbook = demo.of.polynomial();
    demo.of.form.parse("float");
    const auto inFloat = demo.of.polynomial();
    for (double x = -1; x <= 1; x += 0.01) {
        EXPECT_NEAR(textbook(x), right(x), 1e-14);  // 7 terms below 5, some 20 roundings of 1.1e-16 each
        EXPECT_NEAR(inFloat(x), right(x), 1e-5);    // the same of 6e-8
    }
}
