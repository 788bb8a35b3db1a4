// The claims of bump-map, and a test for each.
//
// - [right-straight-on] In a view straight on, a normal map leaves less than a tenth of the error of mere paint.
// - [fails-at-80] At 80 degrees a normal map leaves more than half of paint's error, and over five times its own straight on.
// - [occlusion-sees-relief] From 20 to 80 degrees parallax occlusion leaves at most two thirds of the normal map's error.
// - [finer-maps] From 256 rows on, twice as many rows make the normals of the map four times as exact.
// - [no-mirror-seam] A mirrored wall is lit as well as a plain one; without the sign of its frames it is not.
// - [round-outline] With maps the orange keeps the outline of the sphere; displaced it does not.
// - [no-depth-no-bumps] With depth 0 all methods show the smooth surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 320, height = 240;

// The luminance that the demo draws of it, the upper row first; -1 where nothing is.
std::vector<float> drawn(DemoRun& run, const char* method) {
    (void)run.set("method", method).picture();
    return stage().measure(1);
}

double rmsBetween(const std::vector<float>& a, const std::vector<float>& b) {
    double squares = 0, n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] < 0 || b[i] < 0) continue;
        squares += std::pow(double(a[i]) - double(b[i]), 2);
        ++n;
    }
    EXPECT_GT(n, 100);
    return std::sqrt(squares / n);
}

// Against the displaced mesh, which the study compares with lines of sight.
double errorOf(DemoRun& run, const char* method) { return rmsBetween(drawn(run, method), drawn(run, "displaced")); }

DemoRun wallAt(double angle) {
    DemoRun run("bump-map", width, height);
    run.set("beside", "off").set("angle", angle);
    return run;
}

// The claim is to hold by other light and for another depth, too.
struct Setting {
    double lampTurn, lampHeight, depth;
};
constexpr std::array<Setting, 3> settings{{{50, 40, 0.08}, {-40, 30, 0.08}, {20, 60, 0.15}}};
void take(DemoRun& run, const Setting& setting) {
    run.set("lamp-turn", setting.lampTurn).set("lamp-height", setting.lampHeight).set("depth", setting.depth);
}

long covered(const std::vector<float>& values) {
    return std::count_if(values.begin(), values.end(), [](float value) { return value >= 0; });
}

}  // namespace

TEST(BumpMapFull, right_straight_on) {
    for (const Setting& setting : settings) {
        DemoRun run = wallAt(0);
        take(run, setting);
        const double paint = errorOf(run, "smooth");
        EXPECT_LT(errorOf(run, "normal"), paint / 10);
        EXPECT_LT(errorOf(run, "height"), paint / 10);
    }
}

TEST(BumpMapFull, fails_at_80) {
    for (const Setting& setting : settings) {
        DemoRun run = wallAt(0);
        take(run, setting);
        const double straightOn = errorOf(run, "normal");
        run.set("angle", 80);
        const double grazing = errorOf(run, "normal");
        EXPECT_GT(grazing, 5 * straightOn);
        EXPECT_GT(grazing, errorOf(run, "smooth") / 2);
    }
}

TEST(BumpMapFull, occlusion_sees_relief) {
    for (const Setting& setting : settings) {
        DemoRun run = wallAt(0);
        take(run, setting);
        for (const double angle : {20.0, 50.0, 80.0}) {
            run.set("angle", angle);
            EXPECT_LE(errorOf(run, "occlusion"), 2.0 / 3 * errorOf(run, "normal")) << angle << " " << setting.depth;
        }
    }
}

TEST(BumpMap, finer_maps) {
    DemoRun run("bump-map", 96, 60);
    const auto errorOfMap = [&](int rows) {
        (void)run.set("map-size", rows).picture();
        return run.readout("map-error");
    };
    // Second order, once a brick's edge is many texels wide; the next term is a tenth of it there.
    EXPECT_NEAR(errorOfMap(256) / errorOfMap(512), 4, 0.6);
}

TEST(BumpMapFull, no_mirror_seam) {
    DemoRun run = wallAt(0);
    const double plain = errorOf(run, "normal");
    run.set("mirrored", "on");
    // As good as a plain one, give or take what other bricks are in view.
    EXPECT_LT(errorOf(run, "normal"), 1.5 * plain);
    const auto mirrored = drawn(run, "normal");
    EXPECT_GT(errorOf(run.set("sign", "off"), "normal"), 5 * plain);
    // Without it the right half is as before, and the left one is not.
    const auto without = drawn(run, "normal");
    long left = 0, right = 0;
    for (std::size_t i = 0; i < mirrored.size(); ++i)
        (i % width < width / 2 ? left : right) += std::abs(mirrored[i] - without[i]) > 0.02F;
    EXPECT_EQ(right, 0);
    EXPECT_GT(left, width * height / 20);
}

TEST(BumpMapFull, round_outline) {
    DemoRun run("bump-map", width, height);
    run.set("body", "orange").set("beside", "off").set("angle", 85).set("depth", 0.04);
    const long round = covered(drawn(run, "smooth"));
    EXPECT_GT(round, 100);
    for (const char* method : {"height", "normal", "parallax", "occlusion"})
        EXPECT_EQ(covered(drawn(run, method)), round) << method;
    EXPECT_LT(covered(drawn(run, "displaced")), round * 9 / 10);
}

TEST(BumpMapFull, no_depth_no_bumps) {
    for (const char* body : {"wall", "orange"}) {
        DemoRun run("bump-map", width, height);
        run.set("body", body).set("depth", 0);
        const auto smooth = drawn(run, "smooth");
        // A normal map of (0.5, 0.5, 1) says the vertex's normal, to what floats round: between the map and the brightness lie
        // some thirty operations, each of which may be off by 2^-24 of values about 1, and more where a GPU divides or takes a root.
        for (const char* method : {"height", "normal", "parallax", "occlusion"})
            EXPECT_LT(rmsBetween(drawn(run, method), smooth), 32 * std::exp2(-24)) << body << " " << method;
        // Another mesh, whose normals are interpolated over other triangles: an eighth of the square of 2 pi/256.
        EXPECT_LT(rmsBetween(drawn(run, "displaced"), smooth), 1e-4) << body;
    }
}
