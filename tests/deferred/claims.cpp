// What deferred claims, and a test for each.
//
// - [three-ways-one-light] Forward, deferred and lamp by lamp make one picture, of no lamp, one and ninety-six, from afar and with the
//   eye within reach of lamps.
// - [several-targets] One pass stores the colours, the normals and the depths of what is seen.
// - [beyond-one] The sum goes beyond 1 and keeps colours, which eight bits cut off: faces are white then, and with L/(1 + L) none is.
// - [no-upper-end] Twice the power is nowhere darker, and nowhere 1, by L/(1 + L).
// - [half-a-step-is-nothing] Lamps of less than half a step of eight bits add nothing one by one, and all in one they do.
// - [eight-bits-without-floats] Without targets of floats the sum has eight bits, and a sentence says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mv/gl/beyond_es.h"
#include "mv/image/compare.h"
#include "mv/math/color.h"
#include "support/demo_run.h"
#include "support/softpipe.h"

using namespace mv;
using namespace mv::test;

namespace {

long whites(const Picture& picture) { return countPixels(picture, {255, 255, 255}); }

}  // namespace

TEST(DeferredFull, three_ways_one_light) {
    DemoRun run("deferred", 400, 240);
    for (const auto& [lamps, distance] : {std::pair{0, 0.0}, {1, 0.0}, {96, 0.0}, {96, -4.0}, {48, 12.0}}) {
        run.set("lamps", lamps).set("distance", distance);
        const Picture forward = run.set("way", "forward").picture();
        EXPECT_GT(countColors(forward), lamps == 0 ? 5 : 20) << lamps;  // without lamps there are colours alone
        for (const char* way : {"deferred", "lamp-by-lamp"}) {
            // Normals of 10 bits lean by up to a thousandth, and sums of half floats are off by 1/2048 of themselves: less than 3 levels. An
            // edge's pixel may be another surface's: as few as golden pictures allow another renderer
            EXPECT_LE(compare(forward, run.set("way", way).picture(), 3).fraction, 0.001)
                << way << ", " << lamps << ", " << distance;
        }
    }
}

TEST(DeferredFull, several_targets) {
    DemoRun run("deferred");
    const Picture four = run.preset("targets").picture();
    // The floor in front, in each quarter
    const int x = 150, y = 170;
    const auto expected = [](double part) { return int(std::lround(255 * part)); };
    const Pixel color = four.at(x, y), normal = four.at(400 + x, y), depth = four.at(x, 240 + y);
    EXPECT_NEAR(color.red, expected(srgbFromLinear(0.75)), 1);
    EXPECT_NEAR(color.blue, expected(srgbFromLinear(0.7)), 1);
    EXPECT_NEAR(normal.red, 128, 1);
    EXPECT_NEAR(normal.green, 255, 1);  // up
    EXPECT_NEAR(normal.blue, 128, 1);
    EXPECT_EQ(depth.red, depth.green);
    // Farther away it is deeper
    EXPECT_GT(four.at(250, 240 + 70).red, depth.red + 20);
    // And above the balls there is nothing
    for (const auto& [left, upper] : {std::pair{0, 0}, {400, 0}, {0, 240}, {400, 240}})
        EXPECT_TRUE(sameColor(four.at(left + 200, upper + 5), {23, 26, 31})) << left << ", " << upper;
    EXPECT_NE(run.set("show", "picture").picture(), four);
}

TEST(DeferredFull, beyond_one) {
    DemoRun run("deferred");
    const Picture pressed = run.picture();
    EXPECT_GT(run.readout("beyond-one"), 1) << "percent of what is seen, so that it is seen at a glance";
    EXPECT_EQ(whites(pressed), 0);
    const Picture cut = run.preset("clamped").picture();
    EXPECT_EQ(run.readout("beyond-one"), 0);
    EXPECT_GT(whites(cut), 0.005 * cut.width * cut.height) << "spots that are seen at a glance";
    // What is cut off before it is pressed is half of white at most
    const Picture late = run.set("tone", "reinhard").picture();
    int brightest = 0;
    for (std::size_t i = 0; i < late.rgba.size(); ++i)
        brightest = std::max(brightest, i % 4 == 3 ? 0 : int(late.rgba[i]));
    EXPECT_LE(brightest, int(std::lround(255 * srgbFromLinear(1 / (1 + 0.0722)))));
}

TEST(DeferredFull, no_upper_end) {
    DemoRun run("deferred", 200, 120);
    // Both pictures are rounded by half a level, where the curve from levels to light rises by at most 2.4/1.055
    const double rounding = 2.4 / 1.055 / 255;
    Picture before = run.set("power", 0.03125).picture();
    for (double power = 0.0625; power <= 4; power *= 2) {
        const Picture now = run.set("power", power).picture();
        // The luminance, not each channel: a surface's colour stays
        const auto luminance = [](const Pixel& p) {
            return 0.2126 * linearFromSrgb(p.red / 255.0) + 0.7152 * linearFromSrgb(p.green / 255.0) +
                   0.0722 * linearFromSrgb(p.blue / 255.0);
        };
        for (int y = 0; y < now.height; ++y) {
            for (int x = 0; x < now.width; ++x)
                ASSERT_GE(luminance(now.at(x, y)), luminance(before.at(x, y)) - rounding) << power;
        }
        EXPECT_EQ(whites(now), 0);
        before = now;
    }
}

TEST(DeferredFull, half_a_step_is_nothing) {
    DemoRun run("deferred", 200, 120);
    run.preset("too-dim-to-add").set("power", 0.001).set("lamps", 0);
    const Picture none = run.picture();
    run.set("lamps", 96);
    // Within 0.7 m of a lamp a white surface gets half a step or more
    const double one = compare(none, run.picture()).fraction,
                 all = compare(none, run.set("way", "deferred").picture()).fraction;
    EXPECT_GT(all, 0.25) << "of the picture is lighter by the lamps together";
    if (sumsBeforeRounding()) return;
    EXPECT_LT(one, all / 4) << "and by one after the other only what is near a lamp";
}

TEST(Deferred, eight_bits_without_floats) {
    stage().close();
    withhold({beyond_es::floatTargets});
    {
        DemoRun run("deferred", 200, 120);
        const Picture picture = run.picture();
        ASSERT_EQ(run.messages().size(), 1U);
        EXPECT_NE(run.messages()[0].find("the sum of light has eight bits"), std::string::npos) << run.messages()[0];
        EXPECT_GT(countColors(picture), 20);
    }
    withhold({});
    stage().close();
}
