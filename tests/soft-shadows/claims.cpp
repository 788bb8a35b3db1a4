// The claims of soft-shadows, and a test for each.
//
// - [penumbra-width] Dark to lit takes the lamp's size times the caster's height over the lamp's height above it.
// - [sharp-where-they-touch] The shadow of an upright edge is sharp at its foot and grows softer on the way out.
// - [points-converge] The error of N points, summed in float, falls with a slope of -0.5 to -1 in N.
// - [eight-bit-floor] A sum in 8 bits is as right as one in float up to 256 points, with an error of about 1e-3 there. A share of
//   1/1024 is less than half a step, and is refused.
// - [pcf-does-not-converge] No kernel and no map brings a blur of fixed size below the error of 16 points.
// - [blur-in-the-picture] A blur of the shadow's picture is as wide in pixels at any size of the picture, is smeared over
//   the edges of what stands before the shadow, and is of no size as right as 16 points.
// - [pcss-adapts] Lifting the caster widens the penumbra of pcss as it should, and hardly that of pcf.
// - [shape-of-the-lamp] A tube's penumbra is as wide as its length across its end and a twelfth of that along it, a disc's the
//   same from every side, a square's by the root of 2 wider across its corner.
// - [dark-once] Where the shadows of two casters overlap, a point of the lamp is taken away once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/demo/demo.h"
#include "mv/math/projection.h"
#include "mv/study/study.h"
#include "shared/scenes.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// The part of the lamp that the surfaces of the present settings see; -1 where nothing counts.
std::vector<float> litOf(DemoRun& run) {
    run.picture();
    return stage().measure(1);
}

// The errors of the cube's scene, without times, in a picture small enough for a test.
StudyRun errorsOf(std::vector<StudyLine> lines) {
    Study study = *findDemo("soft-shadows").study;
    study.scenes = {study.scenes.front()};
    study.lines = std::move(lines);
    study.width = 160;
    study.height = 120;
    return runStudy(stage(), study, {.timed = false});
}

std::vector<StudyLine> linesNamed(const std::vector<std::string>& names) {
    std::vector<StudyLine> lines;
    for (const StudyLine& line : findDemo("soft-shadows").study->lines) {
        if (std::find(names.begin(), names.end(), line.method) != names.end()) lines.push_back(line);
    }
    return lines;
}

double rms(const StudyRun& run, const std::string& method, const std::string& parameter) {
    for (const StudyRow& row : run.rows) {
        if (row.method != method || row.parameter != parameter) continue;
        EXPECT_TRUE(row.ok()) << row.status;
        return row.all.rms;
    }
    ADD_FAILURE() << "no row " << method << " " << parameter;
    return NAN;
}

}  // namespace

TEST(SoftShadowsFull, penumbra_width) {
    DemoRun run("soft-shadows", 64, 48);  // the readout has a picture of its own
    run.preset("touching");
    run.set("lights", "256");
    struct Case {
        std::string scene;
        double lamp, edge;  // heights
    };
    for (const Case& c :
         {Case{"cube", cubeOnPlane(1).lights[0].position.y, 1}, {"table", mv::table(1).lights[0].position.y, 0.72}}) {
        for (const double size : {0.1, 0.5, 0.8}) {
            for (const double lifted : {0.0, 0.4}) {
                run.set("scene", c.scene).set("lamp-size", size).set("caster-height", lifted).picture();
                const double below = c.edge + lifted, theory = size * below / (c.lamp - below);
                EXPECT_NEAR(run.readout("penumbra-theory"), theory, 1e-12);
                // The outermost of 16 random points in a cell of 1/16 leaves out 1/17 of it: at both ends together 0.7 %
                // of the width, three times that at worst. The line's pixels are 2 (width + 0.25)/1024 long.
                EXPECT_NEAR(run.readout("penumbra"), theory, 0.02 * theory + 4 * (theory + 0.25) / 1024)
                    << c.scene << ", lamp " << size << ", lifted by " << lifted;
            }
        }
    }
}

TEST(SoftShadowsFull, shape_of_the_lamp) {
    DemoRun run("soft-shadows", 64, 48);
    run.preset("touching");
    run.set("lights", "1024").set("lamp-size", 0.8);
    const double high = cubeOnPlane(1).lights[0].position.y, whole = 0.8 / (high - 1);
    struct Case {
        const char* shape;
        double turn, extent;
    };
    for (const Case& c : {Case{"tube", 0, 1},
                          {"tube", 90, 1.0 / 12},
                          {"disc", 0, 1},
                          {"disc", 45, 1},
                          {"square", 0, 1},
                          {"square", 45, std::sqrt(2.0)}}) {
        run.set("lamp-shape", c.shape).set("lamp-turn", c.turn).picture();
        SCOPED_TRACE(std::string(c.shape) + " turned by " + std::to_string(c.turn));
        EXPECT_NEAR(run.readout("penumbra-theory"), c.extent * whole, 1e-12);
        // A penumbra that ends in a corner has few points there, and the outermost of a thousandth counts as none.
        EXPECT_NEAR(run.readout("penumbra"), c.extent * whole, 0.08 * c.extent * whole + 0.003);
    }
    // One map is asked for the disc, not the square about it: less is dark.
    run.preset("blurred-as-wide-as-needed");
    const auto lit = [&](const char* shape) {
        double sum = 0;
        for (const float part : litOf(run.set("lamp-shape", shape))) sum += part > 0 ? double(part) : 0;
        return sum;
    };
    EXPECT_NE(lit("disc"), lit("square"));
}

TEST(SoftShadows, sharp_where_they_touch) {
    DemoRun run("soft-shadows", 1280, 960);
    run.preset("touching");
    const std::vector<float> lit = litOf(run.set("lights", "256"));
    const mat4 clipFromWorld = run.matrix("clipFromWorld");
    // The cube's upright edge nearest the eye, the lamp, and the way from the edge's shadow to the light, along the floor
    const Scene scene = cubeOnPlane(1);
    const vec3 foot(scene.objects[1].worldFromObject * vec4(-0.5, 0, 0.5, 1)), lamp(scene.lights[0].position);
    const vec3 outwards = glm::normalize(glm::cross(foot - lamp, vec3(0, 1, 0)));
    const auto litAt = [&](const vec3& p) {
        const vec2 pixel = pixelFromNdc(ndcFromClip(clipFromWorld * vec4(p, 1)), 1280, 960);
        return lit.at(pixelIndex(int(pixel.x), 959 - int(pixel.y), 1280));
    };
    // How far out the last of the shadow is, for the shadows of the edge's points
    std::vector<double> soft;
    for (const double y : {0.05, 0.3, 0.6, 0.9}) {
        const vec3 edge = foot + vec3(0, y, 0), shadow = lamp + (edge - lamp) * (lamp.y / (lamp.y - y));
        double out = 0;
        while (out < 0.5 && litAt(shadow + out * outwards) < 0.99F) out += 0.002;
        soft.push_back(out);
    }
    // A pixel is some 0.005 of the floor.
    EXPECT_LT(soft[0], 0.02);
    EXPECT_GT(soft[3], 0.12);
    for (std::size_t i = 1; i < soft.size(); ++i) EXPECT_GT(soft[i], soft[i - 1] + 0.02) << i;
}

TEST(SoftShadowsFull, points_converge) {
    DemoRun run("soft-shadows");
    run.preset("touching");
    const StudyRun study = errorsOf(linesNamed({"matrix, float"}));
    double last = 1;
    for (const char* n : {"1", "4", "16", "64", "256", "1024"}) {
        EXPECT_LT(rms(study, "matrix, float", n), last) << n;
        last = rms(study, "matrix, float", n);
    }
    // One point in each cell: an edge crosses sqrt(n) of them, which is n^-3/4; random points would have n^-1/2.
    const auto slope = errorSlope(study, "cube", "matrix, float");
    ASSERT_TRUE(slope);
    EXPECT_LT(*slope, -0.5);
    EXPECT_GT(*slope, -1);
}

TEST(SoftShadowsFull, eight_bit_floor) {
    DemoRun run("soft-shadows");
    run.preset("touching");
    const StudyRun study = errorsOf(linesNamed({"matrix, float", "matrix, 8-bit"}));
    const auto floats = [&](const char* n) { return rms(study, "matrix, float", n); };
    const auto bytes = [&](const char* n) { return rms(study, "matrix, 8-bit", n); };
    EXPECT_NEAR(bytes("4"), floats("4"), 0.1 * floats("4"));  // few points: the sum's rounding does not show
    // 256 shares of 1/256 are rounded to 1/255 each, and their sum is cut off at 1: a darkness is too large by 1/256 at
    // most. In the 4 % of the pixels that are dark that is 0.0008 of all, beside the 0.001 that 256 points are wrong by:
    // together 1.28 times that.
    for (const char* n : {"16", "64", "256"}) EXPECT_NEAR(bytes(n), floats(n), 0.3 * floats(n)) << n;
    EXPECT_GT(bytes("256"), 0.7e-3);
    EXPECT_LT(floats("1024"), 0.6e-3);
    // 255/1024 of a step rounds to 0: refused by every method that adds points up, and by no other.
    run.set("accumulate", "8-bit").set("lights", "1024");
    for (const char* method : {"matrix", "maps"}) EXPECT_THROW(run.set("method", method).picture(), Error) << method;
    for (const char* method : {"pcf", "pcss"}) EXPECT_NO_THROW(run.set("method", method).picture()) << method;
    EXPECT_NO_THROW(run.set("method", "matrix").set("lights", "256").picture());
    EXPECT_NO_THROW(run.set("accumulate", "float").set("lights", "1024").picture());
}

TEST(SoftShadowsFull, pcf_does_not_converge) {
    DemoRun run("soft-shadows");
    run.preset("touching");
    std::vector<StudyLine> lines = linesNamed({"matrix, float"});
    lines.front().values = {"16"};
    for (const char* resolution : {"256", "512", "1024", "2048"}) {
        lines.push_back(
            {resolution, {{"method", "pcf"}, {"resolution", resolution}}, "taps", {"1", "5", "9", "15", "31"}});
    }
    const StudyRun study = errorsOf(lines);
    int rows = 0;
    for (const StudyRow& row : study.rows) {
        if (row.method == "matrix, float") continue;
        ++rows;
        EXPECT_TRUE(row.ok()) << row.status;
        EXPECT_GT(row.all.rms, 1.5 * rms(study, "matrix, float", "16")) << row.method << ", " << row.parameter;
    }
    EXPECT_EQ(rows, 20);
}

TEST(SoftShadowsFull, blur_in_the_picture) {
    const auto partly = [](const char* method, int width, int height) {
        DemoRun run("soft-shadows", width, height);
        run.preset("touching");
        long pixels = 0;
        for (const float lit : litOf(run.set("method", method).set("taps", 9))) pixels += lit > 0 && lit < 1 ? 1 : 0;
        return double(pixels);
    };
    // An edge is twice as long in pixels in a picture of twice the size; the width of a blur on the map grows with it, too. Ends and
    // corners are neither, so what is asked is whether pixels go with the size or with its square, by the nearest exponent.
    const auto exponent = [&](const char* method) {
        return std::lround(std::log2(partly(method, 640, 480) / partly(method, 320, 240)));
    };
    EXPECT_EQ(exponent("blur"), 1);
    EXPECT_EQ(exponent("pcf"), 2);

    // Pixels of legs, vase and apple that see the whole lamp and are darkened: the shadow behind reaches over their edges.
    DemoRun run("soft-shadows");
    run.preset("blurred-in-the-picture");
    const std::vector<float> blur = litOf(run), oneLook = litOf(run.set("taps", 1)),
                             truth = litOf(run.set("method", "maps").set("lights", 64));
    const Picture picture = run.picture();
    long smeared = 0, unblurred = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const int x = int(i) % picture.width, y = int(i) / picture.width;
        const bool isFloor = std::abs(picture.at(x, y).red - picture.at(x, y).blue) < 15;  // the floor is grey
        if (isFloor || truth[i] < 1) continue;
        smeared += blur[i] < 0.8F ? 1 : 0;
        unblurred += oneLook[i] < 0.8F ? 1 : 0;
    }
    // Half of 15 pixels, over 100 pixels of edges at least; and by one look only what the two maps round otherwise there.
    EXPECT_GT(smeared, 7 * 100);
    EXPECT_LT(unblurred, 100);

    run.preset("touching");
    std::vector<StudyLine> lines = linesNamed({"matrix, float"});
    lines.front().values = {"16"};
    const std::vector<std::string> taps{"1", "5", "9", "15", "31"};
    lines.push_back({"blur", {{"method", "blur"}}, "taps", taps});
    lines.push_back({"pcf", {{"method", "pcf"}}, "taps", {"1"}});
    const StudyRun study = errorsOf(lines);
    for (const std::string& count : taps)
        EXPECT_GT(rms(study, "blur", count), rms(study, "matrix, float", "16")) << count;
    EXPECT_EQ(rms(study, "blur", "1"), rms(study, "pcf", "1"));  // one look each
}

TEST(SoftShadowsFull, pcss_adapts) {
    DemoRun run("soft-shadows");
    run.preset("touching");
    run.set("lamp-size", 0.5).set("taps", 15);
    const auto widthOf = [&](const std::string& method, double lifted) {
        run.set("method", method).set("caster-height", lifted).picture();
        return run.readout("penumbra");
    };
    for (const double lifted : {0.1, 0.3, 0.6}) {
        const double pcss = widthOf("pcss", lifted), theory = run.readout("penumbra-theory");
        // The outermost of 15 looks is half a fifteenth inside the lamp's edge; the map's texels are 0.002 of the floor.
        EXPECT_NEAR(pcss, theory * 14 / 15, 0.02 * theory) << lifted;
    }
    const double theory = run.readout("penumbra-theory");
    EXPECT_LT(widthOf("pcf", 0.6), 0.2 * theory);
    EXPECT_LT(widthOf("pcf", 0.6) / widthOf("pcf", 0.1), 1.5);
    EXPECT_GT(widthOf("pcss", 0.6) / widthOf("pcss", 0.1), 1.7);  // theory: 0.4 / 0.22
}

TEST(SoftShadowsFull, dark_once) {
    DemoRun run("soft-shadows");
    run.preset("touching");
    run.set("scene", "table");
    long dark = 0;
    for (const float lit : litOf(run.set("lights", "1"))) {
        ASSERT_TRUE(lit == 0 || lit == 1 || lit == -1) << lit;
        dark += lit == 0 ? 1 : 0;
    }
    EXPECT_GT(dark, 10000);
    // More points than the 254 that the stencil counts: it begins again, and what all of them leave dark is exactly dark.
    long wholly = 0;
    for (const float lit : litOf(run.set("lights", "256").set("lamp-size", 0.3))) {
        ASSERT_TRUE((lit >= 0 && lit <= 1) || lit == -1) << lit;
        wholly += lit == 0 ? 1 : 0;
    }
    EXPECT_GT(wholly, 5000);
}
