#include "mv/motion/usual_eases.h"

#include <string>
#include <vector>

#include "math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

struct Kind {
    std::string name;
    double (*value)(double, EaseSide);
    double (*slope)(double, EaseSide);
};
const std::vector<Kind> kinds{{"cubic", cubicEase, cubicEaseSlope},
                              {"sine", sineEase, sineEaseSlope},
                              {"back", backEase, backEaseSlope},
                              {"elastic", elasticEase, elasticEaseSlope},
                              {"bounce", bounceEase, bounceEaseSlope}};
constexpr EaseSide sides[] = {EaseSide::in, EaseSide::out, EaseSide::inOut};

}  // namespace

TEST(UsualEases, begin_at_0_and_end_at_1_exactly) {
    for (const Kind& kind : kinds) {
        for (const EaseSide side : sides) {
            EXPECT_EQ(kind.value(0, side), 0) << kind.name;
            EXPECT_EQ(kind.value(1, side), 1) << kind.name;
        }
        EXPECT_EQ(kind.value(0.5, EaseSide::inOut), 0.5) << kind.name;
    }
}

TEST(UsualEases, out_is_in_backwards_and_in_out_has_half_of_each) {
    for (const Kind& kind : kinds) {
        for (int i = 0; i <= 64; ++i) {
            const double t = i / 64.0;
            EXPECT_EQ(kind.value(t, EaseSide::out), 1 - kind.value(1 - t, EaseSide::in)) << kind.name << t;
            EXPECT_EQ(kind.slope(t, EaseSide::out), kind.slope(1 - t, EaseSide::in)) << kind.name << t;
            EXPECT_EQ(kind.value(t / 2, EaseSide::inOut), kind.value(t, EaseSide::in) / 2) << kind.name << t;
            EXPECT_NEAR(kind.value(0.5 + t / 2, EaseSide::inOut), 0.5 + kind.value(t, EaseSide::out) / 2, 4e-16)
                << kind.name << t;
        }
    }
}

TEST(UsualEases, the_slope_is_the_difference_of_values) {
    for (const Kind& kind : kinds) {
        for (const EaseSide side : sides) {
            for (int i = 1; i < 50; ++i) {
                // At 11ths and their halves the bounce has corners, and inOut one at 1/2
                const double t = (i + 0.37) / 51, h = 1e-5;
                const auto f = [&](double steps) { return kind.value(t + steps * h, side); };
                const double difference = (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * h);
                // Fourth order: h^4 times a fifth derivative, 1e8 of the elastic curve, and roundings over h
                EXPECT_NEAR(kind.slope(t, side), difference, 1e-8) << kind.name << " at " << t;
            }
        }
    }
}

// Values of the curves' published formulas, worked out by hand: Penner's, as easings.net has them.
TEST(UsualEases, are_the_published_curves) {
    EXPECT_EQ(cubicEase(0.5, EaseSide::in), 0.125);
    EXPECT_EQ(cubicEase(0.25, EaseSide::inOut), 4 * 0.25 * 0.25 * 0.25);
    EXPECT_NEAR(sineEase(0.5, EaseSide::in), 1 - std::sqrt(0.5), 1e-16);
    EXPECT_NEAR(sineEase(1 / 3.0, EaseSide::out), 0.5, 4e-16);
    EXPECT_NEAR(sineEase(0.25, EaseSide::inOut), (1 - std::sqrt(0.5)) / 2, 1e-16);
    EXPECT_NEAR(backEase(0.5, EaseSide::in), 2.70158 * 0.125 - 1.70158 * 0.25, 1e-16);
    EXPECT_NEAR(bounceEase(4 / 11.0, EaseSide::out), 1, 1e-15);     // it touches the ground
    EXPECT_NEAR(bounceEase(6 / 11.0, EaseSide::out), 0.75, 1e-15);  // and comes back to a quarter
    EXPECT_NEAR(bounceEase(9 / 11.0, EaseSide::out), 0.9375, 1e-15);
    EXPECT_NEAR(bounceEase(0.2, EaseSide::out), 7.5625 * 0.04, 1e-15);
    for (const double t : {0.1, 0.35, 0.8, 0.95}) {
        const double published = -std::pow(2, 10 * t - 10) * std::sin((10 * t - 10.75) * (2 * pi / 3));
        EXPECT_NEAR(elasticEase(t, EaseSide::in), published, 1e-15);
        EXPECT_NEAR(elasticEase(t, EaseSide::out), std::pow(2, -10 * t) * std::sin((10 * t - 0.75) * (2 * pi / 3)) + 1,
                    1e-15);
    }
    // How far back is at most: at t = 2s/(3(s + 1)), a tenth
    EXPECT_NEAR(backEase(2 * 1.70158 / (3 * 2.70158), EaseSide::in), -0.1, 1e-5);
    EXPECT_NEAR(elasticEase(1e-12, EaseSide::in), -std::exp2(-11), 1e-12);  // the jump that the header names
}

TEST(UsualEases, keep_their_digits_at_small_times) {
    for (const double t : {1e-3, 1e-8, 1e-100}) {
        EXPECT_NEAR(sineEase(t, EaseSide::in) / (pi * pi / 8 * t * t), 1, t * t / 4 + 4e-16);
        EXPECT_NEAR(backEase(t, EaseSide::in) / (-1.70158 * t * t), 1, 2 * t + 4e-16);
    }
    EXPECT_EQ(1 - std::cos(pi / 2 * 1e-9), 0);  // the usual form
}

TEST(StepsEase, is_the_css_function) {
    EXPECT_EQ(stepsEase(0, 4), 0);
    EXPECT_EQ(stepsEase(0.2499, 4), 0);
    EXPECT_EQ(stepsEase(0.25, 4), 0.25);
    EXPECT_EQ(stepsEase(0.999, 4), 0.75);
    EXPECT_EQ(stepsEase(1, 4), 1);
    EXPECT_EQ(stepsEase(0.5, 1), 0);
    for (const int steps : {3, 7, 10, 1'000'000}) {
        double before = 0;
        for (int i = 0; i <= 1000; ++i) {
            EXPECT_GE(stepsEase(i / 1000.0, steps), before);
            before = stepsEase(i / 1000.0, steps);
        }
        EXPECT_EQ(before, 1);
    }
}

TEST(UsualEases, refusals_say_what_would_have_been_right) {
    EXPECT_EQ(refusal([] { cubicEase(-0.1, EaseSide::in); }), "cubicEase: t must be 0 to 1, -0.1");
    EXPECT_EQ(refusal([] { sineEaseSlope(1.1, EaseSide::in); }), "sineEaseSlope: t must be 0 to 1, 1.1");
    EXPECT_EQ(refusal([] { elasticEase(notANumber, EaseSide::out); }), "elasticEase: t must be 0 to 1, nan");
    EXPECT_EQ(refusal([] { stepsEase(0.5, 0); }), "stepsEase: steps must be 1 to 1e6, 0");
    EXPECT_EQ(refusal([] { stepsEase(2, 3); }), "stepsEase: t must be 0 to 1, 2");
}
