#include "mv/motion/ease.h"

#include <algorithm>
#include <vector>

#include "math/support.h"
#include "mv/math/require.h"

using namespace mv;
using namespace mv::test;

namespace {

// Each kind with its slope, and where both are to be tried.
struct Kind {
    std::string name;
    std::function<double(double)> value, slope;
};

std::vector<Kind> kinds() {
    std::vector<Kind> list{{"linear", linearEase, linearEaseSlope},
                           {"root", rootEase, rootEaseSlope},
                           {"quadratic", quadraticEase, quadraticEaseSlope}};
    for (const double steepness : {1e-6, 0.1, 10.0, 100.0}) {
        list.push_back({"logistic " + numberText(steepness), [=](double t) { return logisticEase(t, steepness); },
                        [=](double t) { return logisticEaseSlope(t, steepness); }});
    }
    for (const auto& [first, second] :
         {std::pair(vec2(0.25, 0.1), vec2(0.25, 1)), std::pair(vec2(0.42, 0), vec2(0.58, 1)),
          std::pair(vec2(0, 0), vec2(1, 1)), std::pair(vec2(0.9, 0), vec2(0.1, 1))}) {
        const BezierEase ease(first, second);
        list.push_back({"Bezier " + vectorText(first) + vectorText(second), [=](double t) { return ease.value(t); },
                        [=](double t) { return ease.slope(t); }});
    }
    return list;
}

TEST(Ease, BeginsAtZeroAndEndsAtOneExactly) {
    for (const Kind& kind : kinds()) {
        EXPECT_EQ(kind.value(0), 0) << kind.name;
        EXPECT_EQ(kind.value(1), 1) << kind.name;
    }
    for (const double steepness : {1e-6, 1.0, 1e6}) {
        EXPECT_EQ(logisticEase(0, steepness), 0);
        EXPECT_EQ(logisticEase(0.5, steepness), 0.5);
        EXPECT_EQ(logisticEase(1, steepness), 1);
    }
}

TEST(Ease, Rises) {
    for (const Kind& kind : kinds()) {
        double before = 0;
        for (int i = 1; i <= 2000; ++i) {
            const double value = kind.value(i / 2000.0);
            EXPECT_GE(value, before - 4e-16) << kind.name << " at " << i;  // roundings of a 1
            before = value;
        }
    }
}

TEST(Ease, SlopeIsTheDifferenceOfValues) {
    for (const Kind& kind : kinds()) {
        for (int i = 1; i < 50; ++i) {
            const double t = i / 50.0, h = std::min(1e-3, t / 100);  // the root's are of the size of t
            const auto f = [&](double steps) { return kind.value(t + steps * h); };
            // Sixth order: h^6 times a seventh derivative. The steepest curves have 100^7 of it, over 140.
            const double difference = (45 * (f(1) - f(-1)) - 9 * (f(2) - f(-2)) + (f(3) - f(-3))) / (60 * h);
            const bool isSteep = kind.name == "logistic 100" || kind.name.find("0.9") != std::string::npos;
            EXPECT_NEAR(kind.slope(t), difference, isSteep ? 1e-4 : 1e-9) << kind.name << " at " << t;
        }
    }
}

TEST(Ease, LogisticIsTheTextbooksShiftedAndScaled) {
    const auto textbook = [](double t) { return 1 / (1 + std::exp(-10 * (t - 0.5))); };
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0, scaled = (textbook(t) - textbook(0)) / (textbook(1) - textbook(0));
        EXPECT_NEAR(logisticEase(t, 10), scaled, 1e-15);                       // roundings of numbers up to 1
        EXPECT_NEAR(logisticEase(t, 10) + logisticEase(1 - t, 10), 1, 1e-15);  // symmetrical
    }
    EXPECT_GT(textbook(0), 6e-3);  // the jump that the header names
    // Cases in which differences of the textbook's values have no digit left.
    EXPECT_NEAR(logisticEase(1e-20, 100) / (1e-20 * logisticEaseSlope(0, 100)), 1, 1e-13);
}

TEST(BezierEase, ItsXIsTheTime) {
    // The parameter from the value, where y rises as (1/3, 2/3): y = s. So x(value) has to be t.
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const double a = random.number(0, 1), b = random.number(0, 1),
                     t = i < 1000 ? random.number(0, 1) : random.logarithmic(1e-200, 1);
        const double s = BezierEase({a, 1 / 3.0}, {b, 2 / 3.0}).value(t), r = 1 - s;
        // y = s within the rounding of 1/3 and its terms, so x is off by its slope, 3 at most, times some 1e-16 s.
        EXPECT_NEAR(3 * r * r * s * a + 3 * r * s * s * b + s * s * s, t, 4e-15 * std::max(t, s))
            << a << " " << b << " " << t;
    }
}

TEST(BezierEase, IsTheCssFunction) {
    // The handles on the diagonal give an even motion, wherever they are on it.
    for (int i = 0; i <= 20; ++i) EXPECT_NEAR(BezierEase({0.3, 0.3}, {0.8, 0.8}).value(i / 20.0), i / 20.0, 4e-16);
    // ease-in-out is symmetrical: half of the way in half of the time.
    EXPECT_NEAR(BezierEase({0.42, 0}, {0.58, 1}).value(0.5), 0.5, 2e-16);
    // Handles beyond swing beyond.
    EXPECT_LT(BezierEase({0.36, 0}, {0.66, -0.56}).value(0.5), 0);
}

TEST(EaseExtremes, VerticalGraphs) {
    const BezierEase vertical({1, 0}, {0, 1});
    EXPECT_NEAR(vertical.value(0.5), 0.5, 1e-5);  // the cube root of a rounding: 2.2e-16^(1/3) = 6e-6
    EXPECT_LE(vertical.value(0.5 - 1e-9), vertical.value(0.5 + 1e-9));
    EXPECT_EQ(refusal([&] {
                  (void)BezierEase({0, 0.5}, {0.5, 1}).slope(0);
              }),
              "BezierEase::slope: t must not be where the graph is vertical, 0");
    EXPECT_EQ(refusal([] { rootEaseSlope(0); }), "rootEaseSlope: t must be above 0, where the slope is infinite, 0");
    // Handles on their ends: 0/0 by the first derivatives.
    EXPECT_EQ(BezierEase({0, 0}, {1, 1}).slope(0), 1);
    EXPECT_EQ(BezierEase({0, 0}, {0.5, 1}).slope(0), 2);
    EXPECT_EQ(BezierEase({0, 0}, {0, 0}).slope(0), 1);
}

TEST(EaseExtremes, SteepestAndTiniest) {
    EXPECT_EQ(logisticEase(0.4, 1e6), 0);
    EXPECT_EQ(logisticEase(0.6, 1e6), 1);
    EXPECT_NEAR(logisticEase(0.3, 1e-6), 0.3, 1e-13);  // steepness^2/48 off the line
    EXPECT_EQ(logisticEase(0x1p-1074, 10), 0);
    for (const double t : {0x1p-1074, 1e-300, 1e-20, 1 - 0x1p-53}) {
        EXPECT_TRUE(std::isfinite(BezierEase({0, 0.5}, {0, 0.5}).value(t))) << t;
        EXPECT_TRUE(std::isfinite(BezierEase({1, 0}, {1, 1}).value(t))) << t;
    }
    // x = s^3 there, and y = s^3 + 1.5 s (1 - s).
    EXPECT_NEAR(BezierEase({0, 0.5}, {0, 0.5}).value(1e-300) / 1.5e-100, 1, 1e-14);
}

TEST(Ease, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] { linearEase(-0.1); }), "linearEase: t must be 0 to 1, -0.1");
    EXPECT_EQ(refusal([] { rootEase(notANumber); }), "rootEase: t must be 0 to 1, nan");
    EXPECT_EQ(refusal([] { quadraticEaseSlope(1.5); }), "quadraticEaseSlope: t must be 0 to 1, 1.5");
    EXPECT_EQ(refusal([] { logisticEase(0.5, 0); }), "logisticEase: the steepness must be 1e-6 to 1e6, 0");
    EXPECT_EQ(refusal([] { logisticEaseSlope(0.5, infinite); }),
              "logisticEaseSlope: the steepness must be 1e-6 to 1e6, inf");
    EXPECT_EQ(refusal([] { BezierEase({1.1, 0}, {0, 0}); }), "BezierEase: a handle's x must be 0 to 1, (1.1, 0)");
    EXPECT_EQ(refusal([] { BezierEase({0, notANumber}, {0, 0}); }), "BezierEase: a handle must be finite, (0, nan)");
    EXPECT_EQ(refusal([] { (void)BezierEase({0, 0}, {1, 1}).value(2); }), "BezierEase::value: t must be 0 to 1, 2");
}

}  // namespace
