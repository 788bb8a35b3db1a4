// The claims of cube-ortho, and a test for each.
//
// - [identity-and-mirror] The box from -1 to 1 mirrors depth; with near and far exchanged the matrix is the identity.
// - [far-hides-near] With near and far exchanged, far surfaces hide near ones.
// - [distance-changes-nothing] The cube looks exactly the same when it moves away with its box.
// - [box-fills-window] A box of any size fills the window, so the cube is drawn in inverse proportion.
// - [slab-is-a-hexagon] A thin slab across a diagonal leaves a ring of six sides, one of each face.
// - [minus-in-row-three] With near 1 and far 3 the matrix has -2 at the end of row 3; the slide's +2 misses the cube.
// - [nothing-is-refused] A box of no size, and one that misses every face of the cube, are refused.
// - [volume-beside] With the box of view shown, the picture is the same in a smaller pane; the planes of near and far are where their
//   handles are, and follow them.
// - [stretch-is-said] Where the picture's shape is not the volume's, a note says how many times as wide or high shapes are; else none does.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <random>

#include "cube-ortho/cube-ortho.h"
#include "mv/math/projection.h"
#include "support/color_cube.h"
#include "support/demo_run.h"
#include "support/stretch.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr std::array<Pixel, 6> faceColors{
    {{255, 0, 0}, {255, 255, 0}, {0, 255, 0}, {0, 255, 255}, {0, 0, 255}, {255, 0, 255}}};

mat4 diagonal(double x, double y, double z) {
    mat4 m(1);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

DemoRun& turned(DemoRun& run) { return run.set("spin-x", 30).set("spin-y", 40); }

TEST(CubeOrtho, stretch_is_said) { expectStretchIsSaid("cube-ortho", "width", 2, 3); }

}  // namespace

TEST(CubeOrtho, identity_and_mirror) {
    DemoRun run("cube-ortho");
    run.preset("original");
    run.picture();
    EXPECT_EQ(run.readout("near"), -1);
    EXPECT_EQ(run.readout("far"), 1);
    EXPECT_EQ(run.matrix("clipFromView"), diagonal(1, 1, -1));
    run.set("mirror-depth", "on").picture();
    EXPECT_EQ(run.readout("near"), 1);
    EXPECT_EQ(run.readout("far"), -1);
    EXPECT_EQ(run.matrix("clipFromView"), mat4(1));
    // The same said by ortho itself.
    EXPECT_EQ(ortho(-1, 1, -1, 1, -1, 1), diagonal(1, 1, -1));
    EXPECT_EQ(ortho(-1, 1, -1, 1, 1, -1), mat4(1));
}

TEST(CubeOrtho, far_hides_near) {
    DemoRun run("cube-ortho");
    run.preset("original");
    const Picture near = straight(run).picture();
    EXPECT_EQ(countPixels(near, red), 256L * 256);  // the face at z = +0.5, half the window wide
    EXPECT_EQ(countPixels(near, blue), 0);
    const Picture far = run.set("mirror-depth", "on").picture();
    EXPECT_EQ(countPixels(far, blue), 256L * 256);  // the face at z = -0.5
    EXPECT_EQ(countPixels(far, red), 0);
    // Turned, the three faces seen are the other three, and the outline is the same.
    const Picture other = turned(run).picture();
    const Picture usual = run.set("mirror-depth", "off").picture();
    for (const Pixel& color : faceColors) {
        EXPECT_NE(countPixels(other, color) > 1000, countPixels(usual, color) > 1000);
    }
    EXPECT_EQ(countPixels(other, white), countPixels(usual, white));
}

TEST(CubeOrtho, distance_changes_nothing) {
    DemoRun run("cube-ortho");
    run.preset("original");
    const Picture here = turned(run).picture();
    for (const double distance : {1.0, 2.0, 5.0}) {
        EXPECT_EQ(run.set("distance", distance).picture(), here) << distance;
        EXPECT_EQ(run.readout("near"), distance - 1);
        EXPECT_EQ(run.readout("far"), distance + 1);
    }
    // The box goes along: a box that stays around the origin would lose the cube.
    EXPECT_GT(ndcFromClip(ortho(-1, 1, -1, 1, -1, 1) * run.matrix("viewFromModel") * vec4(0, 0, 0, 1)).z, 1);
}

TEST(CubeOrtho, box_fills_window) {
    DemoRun run("cube-ortho");
    run.preset("original");
    straight(run);
    for (const double width : {1.0, 2.0, 4.0, 8.0}) {
        for (const double height : {1.0, 2.0, 4.0}) {
            const Picture picture = run.set("width", width).set("height", height).picture();
            // Powers of two: the cube's edges fall between pixels, so the count is exact.
            EXPECT_EQ(countPixels(picture, red), static_cast<long>(512 / width * (512 / height)));
            EXPECT_EQ(run.readout("pixels-per-unit"), 512 / width);
        }
    }
}

TEST(CubeOrtho, slab_is_a_hexagon) {
    DemoRun run("cube-ortho");
    run.preset("original");
    // acos(1/sqrt 3) from the y axis: the diagonal of the cube is the line of sight.
    const double tilt = degrees(std::atan(std::sqrt(0.5)));
    const Picture picture = run.set("depth", 0.05).set("spin-x", tilt).set("spin-y", 45).picture();
    long ring = 0;
    std::array<long, 6> count{};
    for (std::size_t i = 0; i < 6; ++i) ring += count[i] = countPixels(picture, faceColors[i]);
    for (const long side : count) EXPECT_NEAR(double(side), double(ring) / 6, 0.05 * double(ring));  // pixels of edges
    EXPECT_EQ(ring + countPixels(picture, white), 512L * 512);
    EXPECT_EQ(picture.at(256, 256), white);
    // A regular hexagon of side sqrt(1/2), 256 pixels a unit; 0.05 deep on faces sloped by sqrt(2) is a band of
    // 0.05/sqrt(2). Within 5 %: the band is 9 pixels wide, and pixels are whole.
    const double area = 6 * std::sqrt(0.5) * 0.05 / std::sqrt(2.0) * 256 * 256;
    EXPECT_NEAR(double(ring), area, 0.05 * area);
}

TEST(CubeOrtho, minus_in_row_three) {
    DemoRun run("cube-ortho");
    run.preset("original");
    run.set("distance", 2).picture();
    ASSERT_EQ(run.readout("near"), 1);
    ASSERT_EQ(run.readout("far"), 3);
    const mat4 m = run.matrix("clipFromView");
    EXPECT_EQ(m[3][2], -2);
    EXPECT_EQ(ndcFromClip(m * vec4(0, 0, -1, 1)).z, -1);
    EXPECT_EQ(ndcFromClip(m * vec4(0, 0, -3, 1)).z, 1);
    mat4 slide = m;
    slide[3][2] = +2;
    EXPECT_EQ(ndcFromClip(slide * vec4(0, 0, -1, 1)).z, 3);  // beyond the far plane already
    EXPECT_EQ(ndcFromClip(slide * vec4(0, 0, -3, 1)).z, 5);
    // At the start, where near = -far, the sign cannot be seen.
    run.set("distance", 0).picture();
    EXPECT_EQ(run.matrix("clipFromView")[3][2], 0);
}

TEST(CubeOrtho, nothing_is_refused) {
    DemoRun run("cube-ortho", 128, 128);
    run.preset("original");
    for (const char* knob : {"depth", "width", "height"}) {
        try {
            run.set(knob, 0);
            ADD_FAILURE() << knob;
        } catch (const Error& error) {
            const std::string range = std::string(knob) == "depth" ? "0.05 .. 3" : "0.05 .. 10";
            EXPECT_EQ(error.what(), "--" + std::string(knob) + ": must be " + range + ", '0'");
        }
    }
    straight(run).set("depth", 0.9);
    EXPECT_EQ(run.refusal().rfind("--depth: must reach a face", 0), 0U) << run.refusal();
    run.set("spin-x", 10).set("depth", 0.3).set("width", 0.05).set("height", 0.05);
    EXPECT_EQ(run.refusal().rfind("--depth: must reach a face", 0), 0U) << run.refusal();
    // A case that is let pass has something of the cube in it; every fourth case has faces edge on.
    std::mt19937 random(7);
    const auto pick = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random() % 1000U) / 999.0);
    };
    int drawn = 0, empty = 0;
    for (int i = 0; i < 200; ++i) {
        run.set("spin-x", pick(-360, 360))
            .set("spin-y", i % 4 ? pick(-360, 360) : 180)
            .set("mirror-depth", i % 2 ? "on" : "off");
        run.set("depth", pick(0.05, 1.2)).set("width", pick(0.05, 1.5)).set("height", pick(0.05, 1.5));
        if (!run.refusal().empty()) continue;
        ++drawn;
        empty += countPixels(run.picture(), white) == 128L * 128;
    }
    EXPECT_GT(drawn, 100);
    EXPECT_LT(drawn, 200);
    EXPECT_LE(empty, 2);  // an edge may just come into the box, by less than a pixel
}

TEST(CubeOrtho, volume_beside) {
    DemoRun whole("cube-ortho", 500, 500);
    const Picture both = whole.preset("turned").picture();
    const FrameInfo frame(1, 500, 500);
    const Pane pane = picturePane(frame);
    DemoRun alone("cube-ortho", pane.width, pane.height);
    const Picture picture = alone.preset("turned").set("volume", "off").picture();
    for (int y = 0; y < pane.height; ++y) {
        for (int x = 0; x < pane.width; ++x) ASSERT_EQ(both.at(x, y), picture.at(x, y)) << x << " " << y;
    }
    // The discs are drawn where the far plane's middle is, from outside
    DemoRun run("cube-ortho", 500, 500);
    const auto discAt = [&](const cube_ortho::Settings& s) {
        const ViewFigure figure = cube_ortho::figureOf(s);
        const Pane of = volumePane(frame);
        const vec3 ndc =
            ndcFromClip(outsideFromView(figure, of) * glm::inverse(figure.clipFromView) * vec4(0, 0, 1, 1));
        return run.picture().at(int((ndc.x + 1) / 2 * of.width), 499 - int((ndc.y + 1) / 2 * of.height));
    };
    const Pixel far{217, 64, 13};
    cube_ortho::Settings s;
    EXPECT_TRUE(sameColor(discAt(s), far));
    run.set("depth", 1);
    EXPECT_FALSE(sameColor(discAt(s), far)) << "it has moved";
    s.depth = 1;
    EXPECT_TRUE(sameColor(discAt(s), far));
}
