#include "mv/math/color.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <vector>

#include "mv/error.h"
#include "support.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 anyColor(Random& random) {
    const double r = random.number(0, 1), g = random.number(0, 1);
    return {r, g, random.number(0, 1)};
}

double largest(const vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

template <typename Call>
void expectRefused(Call call, const std::string& rule) {
    try {
        call();
        ADD_FAILURE() << "accepted: " << rule;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(rule), std::string::npos) << error.what();
    }
}

}  // namespace

TEST(Srgb, ends_and_known_values) {
    EXPECT_EQ(linearFromSrgb(0), 0);
    EXPECT_EQ(linearFromSrgb(1), 1);
    EXPECT_EQ(srgbFromLinear(0), 0);
    EXPECT_NEAR(srgbFromLinear(1), 1, 2e-16);
    // Half the light of white is code 188 of 255, and the middle code is a fifth of the light.
    EXPECT_EQ(std::lround(255 * srgbFromLinear(0.5)), 188);
    EXPECT_NEAR(linearFromSrgb(0.5), 0.21404114048223255, 1e-16);
    // An odd function
    EXPECT_EQ(linearFromSrgb(-0.3), -linearFromSrgb(0.3));
    EXPECT_EQ(srgbFromLinear(-0.3), -srgbFromLinear(0.3));
}

TEST(Srgb, there_and_back) {
    for (int i = 0; i <= 100000; ++i) {
        const double code = i / 100000.0;
        // The two branches are 8e-8 apart at most where they change; elsewhere there are roundings, of which the power's
        // are multiplied by 2.4.
        const double tolerance = std::abs(code - 0.04045) < 1e-6 ? 8e-8 : 2e-15;
        ASSERT_NEAR(srgbFromLinear(linearFromSrgb(code)), code, tolerance) << code;
    }
}

TEST(Srgb, rises_and_bends_upwards) {
    double last = linearFromSrgb(0), lastSlope = 0;
    for (int i = 1; i <= 1000; ++i) {
        const double light = linearFromSrgb(i / 1000.0), slope = light - last;
        EXPECT_GT(slope, 0) << i;
        // Up to 0.04045 it is straight, to roundings; at the change it jumps by 2e-8 of a step of 8e-5.
        EXPECT_GE(slope, lastSlope - 3e-8) << i;
        last = light;
        lastSlope = slope;
    }
}

TEST(HslAndHsv, known_colors) {
    EXPECT_EQ(hslFromRgb(vec3(1, 0, 0)), (Hsl{0, 1, 0.5}));
    EXPECT_EQ(hslFromRgb(vec3(1, 1, 0)), (Hsl{60, 1, 0.5}));
    EXPECT_EQ(hslFromRgb(vec3(0, 1, 0)), (Hsl{120, 1, 0.5}));
    EXPECT_EQ(hslFromRgb(vec3(0, 1, 1)), (Hsl{180, 1, 0.5}));
    EXPECT_EQ(hslFromRgb(vec3(0, 0, 1)), (Hsl{240, 1, 0.5}));
    EXPECT_EQ(hslFromRgb(vec3(1, 0, 1)), (Hsl{300, 1, 0.5}));
    EXPECT_EQ(hsvFromRgb(vec3(1, 0, 1)), (Hsv{300, 1, 1}));
    EXPECT_EQ(hsvFromRgb(vec3(0.5, 0.25, 0.25)), (Hsv{0, 0.5, 0.5}));
    EXPECT_EQ(hslFromRgb(vec3(0.75, 0.25, 0.25)), (Hsl{0, 0.5, 0.5}));
    for (const double hue : {-360.0, 0.0, 360.0, 720.0}) {
        EXPECT_EQ(rgbFromHsl(Hsl{hue, 1, 0.5}), vec3(1, 0, 0)) << hue;
        EXPECT_EQ(rgbFromHsv(Hsv{hue, 1, 1}), vec3(1, 0, 0)) << hue;
    }
    EXPECT_EQ(rgbFromHsv(Hsv{-120, 1, 1}), vec3(0, 0, 1));
}

TEST(HslAndHsv, there_and_back) {
    Random random(19);
    for (int i = 0; i < 100000; ++i) {
        const vec3 rgb = anyColor(random);
        const Hsl hsl = hslFromRgb(rgb);
        const Hsv hsv = hsvFromRgb(rgb);
        EXPECT_EQ(hsl.hue, hsv.hue);
        ASSERT_TRUE(hsl.hue >= 0 && hsl.hue < 360) << hsl.hue;
        // A hue is rounded to half a last place of 360, 2.8e-14 of it; a sixth of a turn goes through 0 to 1 at most.
        EXPECT_LE(largest(rgbFromHsl(hsl) - rgb), 2e-15);
        EXPECT_LE(largest(rgbFromHsv(hsv) - rgb), 2e-15);
    }
}

// The hue of a colour does not change with saturation or lightness: both solids turn about the line of greys.
TEST(HslAndHsv, thirds_of_a_turn_exchange_the_components) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Hsl hsl{random.number(0, 120), random.number(0, 1), random.number(0, 1)};
        const vec3 rgb = rgbFromHsl(hsl), turned = rgbFromHsl(Hsl{hsl.hue + 120, hsl.saturation, hsl.lightness});
        EXPECT_LE(largest(vec3(turned.g, turned.b, turned.r) - rgb), 1e-15);
    }
}

TEST(HslAndHsv, greys_have_no_hue) {
    for (int i = 0; i <= 255; ++i) {
        const double grey = i / 255.0;
        EXPECT_EQ(hslFromRgb(vec3(grey)), (Hsl{0, 0, grey}));
        EXPECT_EQ(hsvFromRgb(vec3(grey)), (Hsv{0, 0, grey}));
        EXPECT_EQ(rgbFromHsl(Hsl{77, 0, grey}), vec3(grey));
        // A last place beside it there is one, and any.
        const double beside = std::nextafter(grey, i < 128 ? 1.0 : 0.0);
        if (beside < grey) {
            EXPECT_EQ(hslFromRgb(vec3(beside, grey, beside)).hue, 120);
        } else {
            EXPECT_EQ(hslFromRgb(vec3(grey, beside, grey)).hue, 120);
        }
    }
    // Just before a whole turn: 0, not 360.
    const double hue = hslFromRgb(vec3(1, 0, 1e-17)).hue;
    EXPECT_TRUE(hue >= 0 && hue < 360) << hue;
    const float hueInFloat = hslFromRgb(fvec3(1, 0, 1e-9F)).hue;
    EXPECT_TRUE(hueInFloat >= 0 && hueInFloat < 360) << hueInFloat;
}

TEST(HslAndHsv, refuse_what_is_no_color) {
    for (const vec3& rgb : {vec3(1.5, 1, 1), vec3(-0.01, 0, 0), vec3(notANumber, 0, 0), vec3(0, 0, infinite)}) {
        expectRefused([&] { (void)hslFromRgb(rgb); }, "red, green and blue must be 0 to 1");
        expectRefused([&] { (void)hsvFromRgb(rgb); }, "red, green and blue must be 0 to 1");
    }
    expectRefused([] { (void)rgbFromHsl(Hsl{0, 1, 1.5}); }, "lightness must be 0 to 1");
    expectRefused([] { (void)rgbFromHsl(Hsl{0, -1, 0.5}); }, "saturation must be 0 to 1");
    expectRefused([] { (void)rgbFromHsv(Hsv{0, 1, 1.5}); }, "value must be 0 to 1");
    expectRefused([&] { (void)rgbFromHsl(Hsl{notANumber, 1, 0.5}); }, "hue must be finite");
}

TEST(Oklab, known_colors) {
    EXPECT_EQ(oklabFromLinear(vec3(1)), vec3(1, 0, 0));
    EXPECT_EQ(oklabFromLinear(vec3(0)), vec3(0));
    EXPECT_EQ(linearFromOklab({1, 0, 0}), vec3(1));
    // The matrices of CSS Color 4 as they are printed, in order: light to cones, and their roots to L, a and b. The middle
    // numbers are rounded to 16 digits, of sizes up to 2.4.
    const mat3 cones = transpose(mat3(0.412221469470763, 0.5363325372617348, 0.0514459932675022, 0.2119034958178252,
                                      0.6806995506452344, 0.1073969535369406, 0.0883024591900564, 0.2817188391361215,
                                      0.6299787016738222)),
               roots = transpose(mat3(0.210454268309314, 0.7936177747023054, -0.0040720430116193, 1.9779985324311684,
                                      -2.4285922420485799, 0.450593709617411, 0.0259040424655478, 0.7827717124575296,
                                      -0.8086757549230774));
    Random random(8);
    for (int i = 0; i < 1000; ++i) {
        const vec3 linear = anyColor(random), seen = cones * linear;
        const vec3 printed = roots * vec3(std::cbrt(seen.x), std::cbrt(seen.y), std::cbrt(seen.z));
        EXPECT_LE(largest(oklabFromLinear(linear) - printed), 4e-15);
    }
    // As CSS Color 4 prints them, to five digits
    const vec3 red = oklabFromLinear(vec3(1, 0, 0)), blue = oklabFromLinear(vec3(0, 0, 1));
    EXPECT_LE(largest(red - vec3(0.62796, 0.22486, 0.12585)), 5e-6);
    EXPECT_LE(largest(blue - vec3(0.45201, -0.03246, -0.31153)), 5e-6);
    // Eight times the light is twice as far from black.
    EXPECT_LE(largest(oklabFromLinear(vec3(0.8, 0.4, 0.16)) - 2.0 * oklabFromLinear(vec3(0.1, 0.05, 0.02))), 1e-15);
}

TEST(Oklab, there_and_back) {
    Random random(7);
    for (int i = 0; i < 10000; ++i) {
        const vec3 linear = anyColor(random) * 1.5 - 0.25;
        // Entries of the inverse are up to 4, and its three terms are cubes.
        EXPECT_LE(largest(linearFromOklab(oklabFromLinear(linear)) - linear), 2e-14);
    }
}

// Greys have no chroma, and come back as greys: to the last bit.
TEST(Oklab, greys_rise_along_the_axis) {
    double last = -1;
    for (int i = 0; i <= 100; ++i) {
        const vec3 lab = oklabFromLinear(vec3(i / 100.0));
        EXPECT_GT(lab.x, last);
        EXPECT_EQ(lab, vec3(std::cbrt(i / 100.0), 0, 0));
        const vec3 back = linearFromOklab(lab);
        EXPECT_EQ(back, vec3(back.x));
        EXPECT_NEAR(back.x, i / 100.0, 1e-15);
        last = lab.x;
    }
}

TEST(Chromaticity, primaries_and_white_are_where_the_standard_says) {
    const std::array<vec3, 3> lights{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(glm::distance(chromaticity(xyzFromLinear() * lights[i]), srgbPrimaries[i]), 1e-15);
    }
    EXPECT_LE(glm::distance(chromaticity(xyzFromLinear() * vec3(1)), srgbWhite), 1e-15);
    EXPECT_NEAR(luminance(vec3(1)), 1, 1e-15);
    // The standard prints four digits, so half of the fourth.
    EXPECT_NEAR(luminance(lights[0]), 0.2126, 5e-5);
    EXPECT_NEAR(luminance(lights[1]), 0.7152, 5e-5);
    EXPECT_NEAR(luminance(lights[2]), 0.0722, 5e-5);
    const mat3 product = linearFromXyz() * xyzFromLinear();
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) EXPECT_NEAR(product[c][r], c == r ? 1 : 0, 1e-15);
    }
}

TEST(Chromaticity, mixtures_of_light_lie_on_straight_lines_in_both_diagrams) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const vec3 a = xyzFromLinear() * anyColor(random), b = xyzFromLinear() * anyColor(random);
        const vec2 p = chromaticity(a), q = chromaticity(b), middle = chromaticity(a + b);
        const auto bend = [](const vec2& from, const vec2& to, const vec2& at) {
            return (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
        };
        EXPECT_NEAR(bend(p, q, middle), 0, 1e-15);
        EXPECT_NEAR(bend(uvFromXy(p), uvFromXy(q), uvFromXy(middle)), 0, 1e-15);
    }
    // D65 in u', v': CIE 15 gives 0.1978 and 0.4683.
    EXPECT_NEAR(uvFromXy(srgbWhite).x, 0.1978, 5e-5);
    EXPECT_NEAR(uvFromXy(srgbWhite).y, 0.4683, 5e-5);
}

TEST(Chromaticity, refuses_what_has_none) {
    expectRefused([] { (void)chromaticity(vec3(0)); }, "must be above 0");
    expectRefused([] { (void)chromaticity(vec3(1, -2, 0)); }, "must be above 0");
    expectRefused([] { (void)uvFromXy(vec2(2, 0)); }, "must be above 0");
    expectRefused([] { (void)luminance(vec3(infinite, 0, 0)); }, "must be finite");
}

TEST(ColorMatching, is_the_standard_observer) {
    const auto table = colorMatching();
    ASSERT_EQ(table.size(), 81U);
    vec3 sum(0);
    for (std::size_t i = 0; i < table.size(); ++i) {
        EXPECT_EQ(table[i].nanometres, 380 + 5 * static_cast<int>(i));
        sum += table[i].xyz;
    }
    // Light of equal energy at all wavelengths is white: the three areas are one, 21.3714 of 5 nm each (CIE 15).
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(sum[i], 21.3714, 2e-4);
    // Y is how bright: 1 at its most, 555 nm.
    EXPECT_EQ(table[35].xyz.y, 1);
    for (const SpectralLight& light : table) EXPECT_LE(light.xyz.y, 1);

    // Of the other table, CIE 018:2019's chromaticities: both have six digits, and so have not all the same.
    const std::vector<std::pair<int, vec2>> known{{380, {0.174112, 0.004964}}, {450, {0.156641, 0.017705}},
                                                  {485, {0.068706, 0.200723}}, {505, {0.003859, 0.654823}},
                                                  {520, {0.074302, 0.833803}}, {550, {0.301604, 0.692308}},
                                                  {600, {0.627037, 0.372491}}, {700, {0.734690, 0.265310}}};
    for (const auto& [nanometres, xy] : known) {
        const vec3 xyz = table[static_cast<std::size_t>(nanometres - 380) / 5].xyz;
        EXPECT_LE(glm::distance(chromaticity(xyz), xy), 1e-5) << nanometres;
    }
}

// The spectrum bulges outwards all the way, so what is seen is the inside of it and of the line that closes it; and the
// three primaries are seen.
TEST(ColorMatching, the_spectrum_is_convex) {
    std::vector<vec2> locus;
    for (const SpectralLight& light : colorMatching()) {
        if (light.nanometres >= 420 && light.nanometres <= 660) locus.push_back(chromaticity(light.xyz));
    }
    const auto side = [](const vec2& a, const vec2& b, const vec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    for (std::size_t i = 0; i < locus.size(); ++i) {
        const vec2 a = locus[i], b = locus[(i + 1) % locus.size()];
        // Beyond 540 nm the spectrum is nearly straight, and a place is known to 5e-6 at edges of up to 0.05: four of these.
        EXPECT_LE(side(a, b, locus[(i + 2) % locus.size()]), 2e-6) << i;
        for (const vec2& primary : srgbPrimaries) EXPECT_LT(side(a, b, primary), 0) << i;
    }
}
