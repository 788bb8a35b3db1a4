// The claims of z-buffer, and a test for each.
//
// - [any-order-with-depth] With the depth test all orders of drawing opaque things give one picture, that of the rays.
// - [no-order-without] Without it the bars, which overlap in a cycle, are wrong in every order, sorted ones too.
// - [cut-and-sorted] With each bar cut in two, drawing from far to near by the middles of the parts is right.
// - [first-of-equals] At equal depths the order decides, depth test or not: GL_LESS keeps the first.
// - [blending-needs-order] Translucent panes are right from far to near alone; the depth test makes other orders worse.
// - [fights-by-format] The road fights with the ground in 16 bits, and in 24 from some distance on; in reversed float
//   nowhere where it is 1e-4 of the distance above the ground, and in a few pixels at the vanishing point at 1e-5 (llvmpipe;
//   a GPU that rounds while it interpolates may have the errors of 24 bits on triangles this long).
// - [depth-as-grey] The grey shown is the depth that each mapping's formula gives for the distance.
// - [misordered-as-known] The study's numbers are the known ones: none for reversed float with glClipControl.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "mv/demo/demo.h"
#include "mv/study/study.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const char* const orders[] = {"rgb", "rbg", "grb", "gbr", "brg", "bgr"};

// Percent of the pixels that are not what rays find there.
double wrong(DemoRun& run) {
    run.picture();
    return run.readout("wrong-pixels");
}

DemoRun& road(DemoRun& run, const char* format, const char* mapping) {
    return run.set("scene", "road").set("format", format).set("mapping", mapping);
}

}  // namespace

TEST(ZBufferFull, any_order_with_depth) {
    for (const char* scene : {"cycle", "panes"}) {
        DemoRun run("z-buffer", 300, 300);
        run.set("scene", scene).set("separation", 0.01).set("words", "off");
        for (const double spin : {0.0, 35.0, 160.0}) {
            run.set("spin-x", spin).set("spin-y", spin / 2);
            const Picture first = run.picture();
            EXPECT_EQ(run.readout("wrong-pixels"), 0) << scene << ", turned by " << spin;
            for (const char* order : orders)
                EXPECT_EQ(run.set("order", order).picture(), first) << scene << ", " << order;
            for (const int pieces : {2, 8})
                EXPECT_EQ(wrong(run.set("order", "sorted").set("pieces", pieces)), 0) << scene << ", sorted";
            run.set("order", "rgb").set("pieces", 1);
        }
    }
}

TEST(ZBufferFull, no_order_without) {
    DemoRun run("z-buffer", 300, 300);
    run.set("depth-test", "off");
    std::set<std::string> pictures;
    for (const double spin : {0.0, 10.0, -14.0}) {
        run.set("spin-x", spin).set("spin-y", -spin);
        // Each crossing covers some 3 % of the pixels, and at least one of the three is wrong
        for (const char* order : orders) EXPECT_GT(wrong(run.set("order", order)), 0.3) << order;
        EXPECT_GT(wrong(run.set("order", "sorted")), 0.3);
        EXPECT_EQ(run.messages().size(), 1U);
    }
    // There is an order where there is no cycle: the panes, far to near.
    run.set("scene", "panes").set("separation", 0.01).set("spin-x", 0).set("spin-y", 0);
    EXPECT_EQ(wrong(run.set("order", "bgr")), 0);
    EXPECT_EQ(wrong(run.set("order", "sorted")), 0);
    for (const char* order : {"rgb", "rbg", "grb", "gbr", "brg"}) EXPECT_GT(wrong(run.set("order", order)), 0.3);
}

TEST(ZBuffer, cut_and_sorted) {
    DemoRun run("z-buffer", 300, 300);
    run.set("depth-test", "off").set("order", "sorted");
    for (const double spin : {0.0, 5.0, -5.0}) {
        run.set("spin-x", spin).set("spin-y", spin);
        EXPECT_GT(wrong(run.set("pieces", 1)), 0.3);
        EXPECT_EQ(wrong(run.set("pieces", 2)), 0) << spin;
        EXPECT_EQ(wrong(run.set("pieces", 4)), 0) << spin;
    }
    // Cutting alone does not do it.
    EXPECT_GT(wrong(run.set("order", "rgb").set("pieces", 2)), 0.3);
}

TEST(ZBufferFull, first_of_equals) {
    DemoRun run("z-buffer", 300, 300);
    run.set("scene", "panes").set("separation", 0);
    for (const char* format : {"d16", "d24", "d32f"}) {
        for (const char* mapping : {"standard", "infinite", "reversed", "flipped", "logarithmic"}) {
            run.set("format", format).set("mapping", mapping);
            std::map<std::string, Pixel> middle;
            for (const char* order : orders) middle[order] = run.set("order", order).picture().at(150, 150);
            // All three overlap there, so the first drawn shows, whatever comes after.
            EXPECT_EQ(middle["rgb"], middle["rbg"]) << format << " " << mapping;
            EXPECT_EQ(middle["grb"], middle["gbr"]);
            EXPECT_EQ(middle["brg"], middle["bgr"]);
            EXPECT_NE(middle["rgb"], middle["grb"]);
            EXPECT_NE(middle["grb"], middle["brg"]);
        }
    }
    // Without the test it is the last.
    run.set("depth-test", "off");
    EXPECT_EQ(run.set("order", "rgb").picture().at(150, 150), run.set("order", "grb").picture().at(150, 150));
    // A separation below the step of 16 bits is none: at 5 the step is 25 / (0.1 * 65536) = 0.004, and 5e-4 are equal.
    run.set("depth-test", "on").set("format", "d16").set("mapping", "standard").set("separation", 1e-5);
    EXPECT_GT(wrong(run.set("order", "bgr")), 1);
    EXPECT_EQ(wrong(run.set("format", "d24")), 0);
}

TEST(ZBufferFull, blending_needs_order) {
    DemoRun run("z-buffer", 300, 300);
    run.set("scene", "panes").set("separation", 0.01).set("opacity", 0.6);
    std::map<std::string, double> with, without;
    for (const char* order : orders) with[order] = wrong(run.set("order", order));
    run.set("depth-test", "off");
    for (const char* order : orders) without[order] = wrong(run.set("order", order));
    for (const char* order : orders) {
        const bool farToNear = std::string(order) == "bgr";
        EXPECT_EQ(with[order] == 0, farToNear) << order;
        EXPECT_EQ(without[order] == 0, farToNear) << order;
        if (!farToNear) {
            EXPECT_GT(without[order], 1) << order;
        }
        EXPECT_GE(with[order], without[order]) << order;
    }
    // From near to far, the depth test takes away all that should shine through.
    const Pixel front = run.set("depth-test", "on").set("order", "rgb").picture().at(150, 150);
    EXPECT_EQ(front, run.set("separation", 0).picture().at(150, 150));
    EXPECT_NE(front, run.set("separation", 0.01).set("order", "bgr").picture().at(150, 150));
}

TEST(ZBufferFull, fights_by_format) {
    DemoRun run("z-buffer");
    // The same scene in each: near 0.1, far 10000, a separation of 1e-5 of the distance.
    const double d16 = wrong(road(run, "d16", "standard")), d24 = wrong(road(run, "d24", "standard"));
    EXPECT_GT(d16, 20);  // nearly the whole road
    EXPECT_GT(d24, 0.05);
    EXPECT_LT(d24, 2);  // 24 bits: from s n 2^24 = 17 on, the last 40 lines below the horizon
    // Reversed float and the logarithm: none but three pixels of 360 000 at the vanishing point, where the rasterizer's
    // rounding of corners to 1/256 of a pixel moves a depth by more than the separation.
    // A GPU rounds depths as it interpolates them over the triangle, by a step of the largest, which here is 1 at the eye's end:
    // a road that is one triangle from the eye to the horizon is then no better off than with 24 bits, as above.
    const double most = onLlvmpipe() ? 0.0012 : 2;
    for (const char* mapping : {"reversed", "logarithmic"}) EXPECT_LT(wrong(road(run, "d32f", mapping)), most);
    run.set("separation", 1e-4);
    const double reversed = wrong(road(run, "d32f", "reversed"));
    EXPECT_LE(reversed, onLlvmpipe() ? 0 : wrong(road(run, "d24", "standard")));
    EXPECT_GT(wrong(road(run, "d16", "standard")), 20);
    // Fixed point gains nothing by it, and float little where the driver or the demo goes through -1 .. 1.
    run.set("separation", 1e-5);
    EXPECT_GT(wrong(road(run, "d24", "reversed")), 0.02);
    EXPECT_GT(wrong(road(run, "d24", "infinite")), 0.05);
    run.set("separation", 1e-6);
    EXPECT_GT(wrong(road(run, "d32f", "flipped")), (onLlvmpipe() ? 2 : 1) * wrong(road(run, "d32f", "reversed")));
    // Near is what costs: ten times as far away, ten times as fine.
    run.set("separation", 1e-5);
    EXPECT_LT(wrong(road(run, "d24", "standard").set("near", 1)), d24 / 10);
}

TEST(ZBufferFull, depth_as_grey) {
    DemoRun run("z-buffer", 64, 64);
    run.set("scene", "panes").set("separation", 0).set("show", "depth");
    const double d = 5;
    for (const double n : {0.01, 0.1, 1.0, 2.5}) {
        for (const double f : {10.0, 1000.0}) {
            const std::pair<const char*, double> depths[] = {{"standard", f / (f - n) * (1 - n / d)},
                                                             {"infinite", 1 - n / d},
                                                             {"reversed", n / (f - n) * (f / d - 1)},
                                                             {"flipped", 1 - f / (f - n) * (1 - n / d)},
                                                             {"logarithmic", std::log(1 + d) / std::log(1 + f)}};
            for (const auto& [mapping, depth] : depths) {
                const Picture picture = run.set("near", n).set("far", f).set("mapping", mapping).picture();
                const Pixel seen = picture.at(32, 32), sky = picture.at(0, 0);
                EXPECT_NEAR(seen.red, 255 * depth, 0.51) << mapping << ", near " << n;  // rounded to 8 bits
                EXPECT_EQ(seen.green, seen.red);
                EXPECT_EQ(seen.blue, seen.red);
                const bool nearIsOne = std::string(mapping) == "reversed" || std::string(mapping) == "flipped";
                EXPECT_EQ(sky.red, nearIsOne ? 0 : 255);  // where nothing is, the depth is what it was cleared to
            }
        }
    }
    // Half of the range lies between near and twice near: nearly all of the picture is nearly white.
    EXPECT_GE(run.set("near", 2.5).set("far", 1000).set("mapping", "standard").picture().at(32, 32).red, 128);
    // A slide's "with far 1000 near, the first 2 % of the distances take 98 % of the depths": they take 95.3.
    const double near = d / (1 + 0.02 * 999);
    EXPECT_EQ(run.set("near", near).set("far", 1000 * near).picture().at(32, 32).red, 243);
    // Without the depth test nothing is written.
    EXPECT_EQ(run.set("depth-test", "off").picture().at(32, 32).red, 255);
    // The curve has the same depth at each distance: drawn there, black, and neither above nor below it.
    DemoRun curve("z-buffer", 600, 600);
    curve.set("show", "curve").set("near", 0.1).set("far", 1000);
    for (const auto& [mapping, depthAt1] : {std::pair{"standard", 1000 / 999.9 * 0.9},
                                            {"infinite", 0.9},
                                            {"flipped", 1 - 1000 / 999.9 * 0.9},
                                            {"logarithmic", std::log(2) / std::log(1001)}}) {
        const Picture picture = curve.set("mapping", mapping).picture();
        const double x = 72 + 0.25 * 468, y = 600 - (84 + depthAt1 * (540 - 84));  // 1 is a quarter of the four decades
        const auto darkAt = [&](double up) { return picture.at(int(x), int(y - up)).red < 100; };
        EXPECT_TRUE(darkAt(0) || darkAt(1) || darkAt(-1)) << mapping;
        EXPECT_FALSE(darkAt(8)) << mapping;
        EXPECT_FALSE(darkAt(-8)) << mapping;
    }
}

TEST(ZBufferFull, misordered_as_known) {
    // Percent of 100 000 pairs, from another program with random distances.
    const std::array<std::string, 7> methods{"D24 standard", "D32F standard", "D32F reversed",  "D24 reversed",
                                             "D24 infinite", "D32F flipped",  "D24 logarithmic"};
    const std::pair<std::array<double, 2>, std::array<double, 7>> known[] = {
        {{1e2, 1e-4}, {.03, .03, 0, 0, 0, 0, 0}},
        {{1e2, 1e-5}, {16.6, 16.6, 0, 13.8, 15.6, 9.3, 0}},
        {{1e4, 1e-4}, {28.0, 28.0, 0, 26.8, 27.9, 21.4, 0}},
        {{1e4, 1e-5}, {47.9, 47.9, 0, 46.8, 47.7, 40.6, 0}},
        {{1e6, 1e-5}, {62.7, 62.7, 0, 62.0, 62.7, 57.6, 0}},
        {{1e6, 1e-6}, {77.1, 77.1, 0, 76.3, 77.1, 71.9, 19.1}}};
    DemoRun run("z-buffer", 16, 16);
    const StudyRun result = runStudy(stage(), *findDemo("z-buffer").study, {.timed = false});
    const auto percent = [&](const std::string& method, double far, double separation) {
        for (const StudyRow& row : result.rows) {
            EXPECT_TRUE(row.ok()) << row.status;
            if (row.method == method && std::stod(row.parameter) == far &&
                std::stod(row.settings[1].text) == separation)
                return 100 * row.all.fraction;
        }
        ADD_FAILURE() << "no row of " << method << " " << far << " " << separation;
        return 0.0;
    };
    for (const auto& [setting, values] : known) {
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const double mine = percent(methods[i], setting[0], setting[1]);
            // Three standard deviations of a share of 100 000 random pairs are 0.47 points.
            EXPECT_NEAR(mine, values[i], 0.5) << methods[i] << ", far " << setting[0] << ", " << setting[1];
            if (methods[i] == "D32F reversed") {
                EXPECT_EQ(mine, 0);
            }
        }
    }
    // Sixteen bits are too few however they are spent, and a float near 1 has no finer steps than 24 bits.
    for (const double separation : {1e-4, 1e-5, 1e-6}) {
        for (const double far : {1e2, 1e4, 1e6}) {
            const double d16 = percent("D16 standard", far, separation);
            EXPECT_NEAR(percent("D16 infinite", far, separation), d16, 0.5);
            EXPECT_NEAR(percent("D16 reversed", far, separation), d16, 0.5);
            EXPECT_NEAR(percent("D32F infinite", far, separation), percent("D24 infinite", far, separation), 0.5);
        }
    }
    EXPECT_NEAR(percent("D16 standard", 1e2, 1e-4), 58, 1);  // known to two digits
    EXPECT_NEAR(percent("D16 standard", 1e6, 1e-5), 96, 1);
    // Far does not matter once it is far: for a point at z the step is z z / (n 2^24), whatever far is. Near does.
    run.set("separation", 1e-5).picture();
    const double usual = run.readout("misordered");
    run.set("near", 1).picture();
    EXPECT_LT(run.readout("misordered"), usual - 10);
}
