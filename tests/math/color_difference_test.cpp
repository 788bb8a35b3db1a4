#include "mv/math/color_difference.h"

#include <array>

#include "math/support.h"
#include "mv/math/color.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 labOf(const char* hex) { return labFromLinear(linearFromSrgb(srgbFromHex(hex))); }

}  // namespace

TEST(Lab, is_what_is_published) {
    // From the standard's formulas and sRGB's primaries with D65: (x, y) = (0.3127, 0.3290), as color.js and culori print it
    EXPECT_LT(glm::distance(labOf("#ff0000"), {53.2408, 80.0925, 67.2032}), 0.02);
    EXPECT_LT(glm::distance(labOf("#00ff00"), {87.7347, -86.1827, 83.1793}), 0.02);
    EXPECT_LT(glm::distance(labOf("#0000ff"), {32.2970, 79.1875, -107.8602}), 0.02);
    // White is 100, in the roundings of 116 - 16
    EXPECT_NEAR(labFromLinear(vec3(1)).x, 100, 2e-14);
    EXPECT_EQ(labFromLinear(vec3(0)), vec3(0));
}

TEST(Lab, greys_have_no_color) {
    for (int i = -10; i <= 1000; ++i) {
        const vec3 lab = labFromLinear(vec3(i / 1000.0));
        EXPECT_EQ(lab.y, 0) << i;
        EXPECT_EQ(lab.z, 0) << i;
    }
}

TEST(Lab, the_straight_piece_meets_the_curve) {
    const double at = 216.0 / 24389, little = 1e-9;
    const vec3 below = labFromLinear(vec3(at - little)), above = labFromLinear(vec3(at + little));
    // L* = 903.3 y: over 2e-9 it rises by 1.8e-6, and 8 is the value there
    EXPECT_NEAR(below.x, 8, 1e-6);
    EXPECT_NEAR(above.x - below.x, 2 * little * 24389 / 27, 1e-11);
    EXPECT_EQ(labFromLinear(vec3(1e-300)).x, 1e-300 * (24389.0 / 27));
}

// Sharma, Wu and Dalal (2005), table 1: all 34 pairs, to the four digits that are printed.
TEST(ColorDifference, is_what_is_published) {
    struct Pair {
        vec3 a, b;
        double difference;
    };
    const std::array<Pair, 34> pairs{{
        {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
        {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
        {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
        {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
        {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
        {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
        {{50, 0, 0}, {50, -1, 2}, 2.3669},
        {{50, -1, 2}, {50, 0, 0}, 2.3669},
        {{50, 2.49, -0.001}, {50, -2.49, 0.0009}, 7.1792},
        {{50, 2.49, -0.001}, {50, -2.49, 0.0010}, 7.1792},
        {{50, 2.49, -0.001}, {50, -2.49, 0.0011}, 7.2195},
        {{50, 2.49, -0.001}, {50, -2.49, 0.0012}, 7.2195},
        {{50, -0.001, 2.49}, {50, 0.0009, -2.49}, 4.8045},
        {{50, -0.001, 2.49}, {50, 0.0010, -2.49}, 4.8045},
        {{50, -0.001, 2.49}, {50, 0.0011, -2.49}, 4.7461},
        {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
        {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
        {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
        {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
        {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
        {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
        {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
        {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
        {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
        {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
        {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
        {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
        {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
        {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
        {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
        {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
    }};
    for (const Pair& pair : pairs) {
        EXPECT_NEAR(colorDifference(pair.a, pair.b), pair.difference, 5e-5) << pair.a.y << " " << pair.b.y;
        EXPECT_NEAR(colorDifference(pair.b, pair.a), pair.difference, 5e-5) << pair.b.y << " " << pair.a.y;
    }
}

TEST(ColorDifference, is_symmetrical_and_0_of_a_color_and_itself) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const vec3 a = vec3(50, 0, 0) + random.point(50), b = vec3(50, 0, 0) + random.point(50);
        EXPECT_EQ(colorDifference(a, a), 0);
        const double there = colorDifference(a, b);
        EXPECT_NEAR(colorDifference(b, a), there, 1e-12 * there);
        EXPECT_GT(there, 0);
    }
    EXPECT_NEAR(colorDifference({0, 0, 0}, {100, 0, 0}), 100, 1e-12);
}

TEST(ColorDifference, keeps_its_digits_between_neighbours) {
    // Halved steps are halved differences, as far down as numbers can tell the colours apart
    const vec3 color(60, 30, -20), way(0.3, 1, 0.7);
    const double whole = colorDifference(color, color + 0x1p-20 * way) / 0x1p-20;
    for (int exponent = 21; exponent <= 40; ++exponent) {
        const vec3 other = color + std::ldexp(1.0, -exponent) * way;
        // The rounding of the coordinates of `other`, 2^-48, is a part of the step; so is what the weights change by
        const double allowed = std::ldexp(1.0, exponent - 47) + 1e-6;
        EXPECT_NEAR(colorDifference(color, other) * std::ldexp(1.0, exponent), whole, allowed * whole) << exponent;
    }
}

TEST(ColorDifference, hues_half_a_turn_apart_and_greys) {
    // Exactly opposite: the sign of the turn is a matter of the order, and both orders have one result
    EXPECT_EQ(colorDifference({50, 10, 0}, {50, -10, 0}), colorDifference({50, -10, 0}, {50, 10, 0}));
    EXPECT_EQ(colorDifference({50, 0, 3}, {50, 0, -3}), colorDifference({50, 0, -3}, {50, 0, 3}));
    // A mean hue of 360 degrees and one of 0, on both sides of colours whose hues add up to 360: a jump that is the formula's
    const double below = colorDifference({50, 40, 40}, {50, 100, -100 - 1e-9});
    const double above = colorDifference({50, 40, 40}, {50, 100, -100 + 1e-9});
    EXPECT_GT(std::abs(above / below - 1), 1e-7) << "the colours differ by 1e-11";
    EXPECT_LT(std::abs(above / below - 1), 5e-6);
    // Tiny chroma, of which no seventh power is left
    EXPECT_NEAR(colorDifference({50, 1e-100, 0}, {50, 0, 0}) / 1.5e-100, 1, 1e-12);
    EXPECT_EQ(refusal([] {
                  colorDifference({50, notANumber, 0}, {50, 0, 0});
              }),
              "colorDifference: a colour must be finite, (50, nan, 0)");
    EXPECT_EQ(refusal([] {
                  colorDifference({50, 2e6, 0}, {50, 0, 0});
              }),
              "colorDifference: a colour must be within 1e6, (50, 2e+06, 0)");
}

// Web Content Accessibility Guidelines 2.2: black on white has 21:1, and of greys #767676 is the lightest that has 4.5:1 on white.
TEST(Contrast, is_what_the_guidelines_say) {
    const auto beside = [](const char* a, const char* b) {
        return contrast(linearFromSrgb(srgbFromHex(a)), linearFromSrgb(srgbFromHex(b)));
    };
    EXPECT_NEAR(beside("#000", "#fff"), 21, 1e-13);
    EXPECT_NEAR(beside("#fff", "#000"), 21, 1e-13);
    EXPECT_GE(beside("#767676", "#ffffff"), 4.5);
    EXPECT_LT(beside("#777777", "#ffffff"), 4.5);
    EXPECT_EQ(beside("#123456", "#123456"), 1);
    EXPECT_NE(refusal([] { contrast(vec3(2), vec3(0)); }).find("contrast: a luminance must be 0 to 1, "),
              std::string::npos);
}

TEST(Hex, there_and_back) {
    for (int code = 0; code < 256; ++code) {
        const vec3 srgb(code / 255.0, (255 - code) / 255.0, code / 255.0);
        EXPECT_EQ(srgbFromHex(hexFromSrgb(srgb)), srgb) << code;
    }
    EXPECT_EQ(hexFromSrgb({1, 0.55, 0}), "#ff8c00");
    EXPECT_EQ(srgbFromHex("#F80"), vec3(255 / 255.0, 136 / 255.0, 0));
    EXPECT_EQ(srgbFromHex("#fF8800"), srgbFromHex("#f80"));
    for (const char* wrong : {"", "#", "#12", "#12345", "#1234567", "123456", "#12345g", "#-12", "# 12", "#1 2"}) {
        EXPECT_EQ(refusal([&] { (void)srgbFromHex(wrong); }).rfind("srgbFromHex: a colour must be #rgb or #rrggbb", 0),
                  0U)
            << wrong;
    }
    EXPECT_EQ(refusal([] { (void)hexFromSrgb({0, 1.5, 0}); }), "hexFromSrgb: components must be 0 to 1, (0, 1.5, 0)");
    EXPECT_EQ(refusal([] {
                  (void)hexFromSrgb({0, notANumber, 0});
              }),
              "hexFromSrgb: components must be 0 to 1, (0, nan, 0)");
}
