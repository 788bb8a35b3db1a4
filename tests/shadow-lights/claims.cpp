// The claims of shadow-lights, and a test for each.
//
// - [right-by-rays] The mean over the lights of what they light is what rays show: by volumes away from edges in all pixels
//   but single ones that a light grazes, and by maps the better the larger they are.
// - [linear] Each further light costs the same passes and draws as the one before.
// - [out-of-reach] A light that cannot reach the picture costs nothing, and the picture is the same.
// - [sum-of-lights] Light is added and never taken away: each light adds to the picture without any.
// - [kept] Maps and volumes are kept while light and casters rest; where one moves, they are made anew.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/study/study.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// One row of the study in the present settings, at 320 x 240.
StudyRow compareWithRays(int frame = 1) {
    Study study = *stage().info().study;
    study.scenes = {{"as set", {}}};
    study.lines = {{"as set", {}}};
    study.width = 320;
    study.height = 240;
    study.frame = frame;
    StudyRow row = runStudy(stage(), study, {.timed = false}).rows.at(0);
    EXPECT_EQ(row.status, "ok");
    EXPECT_GT(row.awayFromEdges.n, 10000);
    return row;
}

}  // namespace

TEST(ShadowLightsFull, right_by_rays) {
    DemoRun run("shadow-lights");
    struct Case {
        const char *scene, *lights;
        int frame;
    };
    for (const Case& c : {Case{"lamps", "3", 1},
                          {"lamps", "3", 100},
                          {"circle", "1", 1},
                          {"circle", "5", 40},
                          {"circle", "8", 1},
                          {"circle", "8", 40}}) {
        run.set("scene", c.scene).set("lights", c.lights).set("method", "volumes");
        const std::string what = std::string(c.scene) + " " + c.lights;
        // A light that grazes a surface by some degrees has the side of a volume nearer to it than a step of its depth: the
        // study, which has four times the pixels, finds none with 1, 2, 4 or 8 lights and one with 7.
        const StudyError away = compareWithRays(c.frame).awayFromEdges;
        EXPECT_LE(away.fraction * double(away.n), 1.01) << what;
        // The larger the map, the fewer are wrong: about half as many for twice as large.
        run.set("method", "maps");
        const double coarse = (run.set("resolution", "256"), compareWithRays(c.frame)).all.fraction;
        const double fine = (run.set("resolution", "2048"), compareWithRays(c.frame)).all.fraction;
        EXPECT_LT(coarse, 0.02) << what;
        EXPECT_LT(fine, coarse / 3) << what;
        EXPECT_GT(coarse, 0) << what;
    }
}

TEST(ShadowLightsFull, linear) {
    DemoRun run("shadow-lights");
    run.set("scene", "circle").set("keep", "off");
    for (const char* method : {"volumes", "maps"}) {
        run.set("method", method);
        std::vector<StudyRow> rows;
        for (const int lights : {1, 2, 4, 8}) rows.push_back((run.set("lights", lights), compareWithRays()));
        for (const char* what : {"draws", "passes"}) {
            const double first = countOf(rows[0], what), each = countOf(rows[1], what) - first;
            if (std::string(what) == "draws") {
                EXPECT_GT(each, 0) << method;
            }
            EXPECT_EQ(countOf(rows[2], what), first + 3 * each) << method << ", " << what;
            EXPECT_EQ(countOf(rows[3], what), first + 7 * each) << method << ", " << what;
        }
        // Silhouettes differ from light to light: the triangles are linear to some percent.
        const double first = countOf(rows[0], "triangles"), each = countOf(rows[1], "triangles") - first;
        EXPECT_NEAR(countOf(rows[3], "triangles") / (first + 7 * each), 1, 0.03) << method;
    }
}

TEST(ShadowLightsFull, out_of_reach) {
    DemoRun run("shadow-lights");
    run.set("scene", "circle").set("lights", 8);
    for (const char* method : {"volumes", "maps"}) {
        run.set("method", method).set("reach", 20).set("distance", 0).picture();
        EXPECT_EQ(run.readout("lights-drawn"), 8);
        const Counters all = stage().frameCounters();
        // 3.8 above the floor, and 2.2 from the wall at least: nothing is within 1, and no light costs a draw.
        const Picture dark = run.set("reach", 1).picture();
        EXPECT_EQ(run.readout("lights-drawn"), 0);
        EXPECT_EQ(run.readout("shadows-remade"), 0);
        EXPECT_LT(stage().frameCounters().draws, all.draws / 4);
        // Within 3 come some: the others are left out. A reach at which all are drawn shows that they add nothing there.
        run.set("reach", 3).picture();
        EXPECT_GT(run.readout("lights-drawn"), 0);
        EXPECT_LT(run.readout("lights-drawn"), 8);
        EXPECT_GT(differentPixels(dark, run.picture()), 1000);
    }
    // The lamps reach the ball when the light above them does not: most of the picture is as bright as without that light.
    run.preset("short-reach");
    for (const char* method : {"volumes", "maps"}) {
        const Picture two = run.set("method", method).set("reach", 4).picture();
        EXPECT_EQ(run.readout("lights-drawn"), 2) << method;
        EXPECT_GT(differentPixels(two, run.set("reach", 0.5).picture()), 50000) << method;
    }
}

TEST(ShadowLights, sum_of_lights) {
    // The picture without a light is all lights out of reach; what each of two adds is added in the picture of both.
    DemoRun run("shadow-lights");
    run.set("scene", "lamps").set("method", "volumes");
    const Picture three = run.picture();
    const Picture none = run.set("reach", 0.5).picture();
    // Every pixel is at least as light as without: light is added, never taken away.
    long lighter = 0;
    for (int y = 0; y < three.height; ++y) {
        for (int x = 0; x < three.width; ++x) {
            ASSERT_GE(three.at(x, y).green, none.at(x, y).green) << x << ", " << y;
            lighter += three.at(x, y).green > none.at(x, y).green ? 1 : 0;
        }
    }
    EXPECT_GT(lighter, 100000);
    // The quantity of a study is the mean over the lights: with two it takes the values 0, 1/2 and 1 and no other.
    run.set("scene", "circle").set("lights", 2).set("reach", 20);
    run.picture();
    long seen[3] = {0, 0, 0};
    for (const float value : stage().measure(1)) {
        if (value < 0) continue;
        const double twice = 2.0 * double(value);
        ASSERT_EQ(twice, std::round(twice));
        ++seen[std::lround(twice)];
    }
    EXPECT_GT(seen[0], 100);
    EXPECT_GT(seen[1], 10000);
    EXPECT_GT(seen[2], 10000);
}

TEST(ShadowLightsFull, kept) {
    DemoRun run("shadow-lights");
    for (const char* method : {"volumes", "maps"}) {
        run.set("method", method).set("scene", "circle").set("lights", 4).set("keep", "on");
        run.picture(5);
        run.picture(5);
        EXPECT_EQ(run.readout("shadows-remade"), 0) << method;
        const Picture kept = run.picture(5);
        run.picture(6);
        EXPECT_EQ(run.readout("shadows-remade"), 4) << method;  // all lights have moved
        EXPECT_EQ(differentPixels(run.set("keep", "off").picture(5), kept), 0) << method;
        run.picture(5);
        EXPECT_EQ(run.readout("shadows-remade"), 4) << method;
        // The lamps move the ball, which the third light shines on too: its shadow is made anew as well.
        run.set("scene", "lamps").set("keep", "on").picture(5);
        run.picture(6);
        EXPECT_EQ(run.readout("shadows-remade"), 3) << method;
    }
}
