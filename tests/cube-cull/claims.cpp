// The claims of cube-cull, and a test for each.
//
// - [convex-needs-no-depth] The cube is closed and convex: with back faces culled its pixels need no depth test.
// - [front-is-inside] Culling front faces shows the inside, and so does culling back faces of the other winding.
// - [half-to-five-sixths] From outside 1, 2 or 3 faces are seen, so culling discards 1/2 to 5/6 of all triangles.
// - [eye-inside] Inside the cube no face turns to the eye: culling back faces leaves the axes alone.
// - [open-shows-its-inside] Of the open pot culling leaves out faces that are seen; of the closed cube it leaves out none.
// - [fronts-hide-fronts] The teapot is not convex: front faces hide front faces, so that culling alone does not order them.
// - [apart-as-drawn] Of the faces that are moved apart those are filled that the picture shows, and no other.
// - [lines-stay] Lines have no faces: culling both leaves the axes.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// Turns that show one, two and three faces, and some between.
constexpr std::array<std::array<int, 2>, 6> turns{{{0, 0}, {0, 40}, {35, 30}, {-60, 200}, {90, 0}, {17, -133}}};

}  // namespace

TEST(CubeCullFull, convex_needs_no_depth) {
    DemoRun run("cube-cull");
    run.preset("original");
    for (const auto& [spinX, spinY] : turns) {
        run.set("spin-x", spinX).set("spin-y", spinY).set("cull", "both");
        // The axes pierce the cube, so they are what depth decides; the faces alone are compared by their colours.
        const Picture with = run.set("cull", "back").set("depth", "on").picture();
        const Picture axesOnly = run.set("cull", "both").picture();
        const Picture without = run.set("cull", "back").set("depth", "off").picture();
        long wrong = 0, onAxes = 0;
        for (int y = 0; y < with.height; ++y) {
            for (int x = 0; x < with.width; ++x) {
                const bool axis = axesOnly.at(x, y) != axesOnly.at(0, 0);
                onAxes += axis;
                wrong += !axis && with.at(x, y) != without.at(x, y);
            }
        }
        EXPECT_LT(onAxes, 3 * 600) << "three lines across the picture at most; more would hide what is compared";
        EXPECT_EQ(wrong, 0) << "turned by " << spinX << ", " << spinY;
    }
    // The other order of faces, so that the check can fail: with all faces drawn, depth does decide.
    const Picture withAll = run.set("cull", "none").set("depth", "on").picture();
    EXPECT_GT(differentPixels(withAll, run.set("depth", "off").picture()), 1000);
}

TEST(CubeCull, front_is_inside) {
    DemoRun run("cube-cull");
    run.preset("original");
    run.set("spin-x", 20).set("spin-y", 30);
    const Picture outside = run.picture();
    const Picture inside = run.set("cull", "front").picture();
    EXPECT_EQ(run.readout("surviving"), 6);
    EXPECT_GT(differentPixels(outside, inside), 10000);
    const Picture otherWinding = run.set("cull", "back").set("winding", "cw").picture();
    EXPECT_EQ(inside, otherWinding);
    // From outside the far faces are blue, magenta and cyan's opposites: yellow, red and green.
    EXPECT_GT(countPixels(inside, {255, 255, 0}), 1000);
    EXPECT_EQ(countPixels(inside, {0, 255, 255}), 0);
}

TEST(CubeCull, half_to_five_sixths) {
    DemoRun run("cube-cull");
    run.preset("original");
    std::array<bool, 4> seen{};
    for (const auto& [spinX, spinY] : turns) {
        run.set("spin-x", spinX).set("spin-y", spinY).picture();
        const double facing = run.readout("facing");
        ASSERT_GE(facing, 1);
        ASSERT_LE(facing, 3);
        seen[static_cast<std::size_t>(facing)] = true;
        EXPECT_EQ(run.readout("culled"), 12 - 2 * facing);  // two triangles a face
        EXPECT_EQ(run.readout("surviving"), 2 * facing);
        EXPECT_EQ(run.readout("outside"), 0);
    }
    EXPECT_TRUE(seen[1] && seen[2] && seen[3]) << "the turns must show one, two and three faces";
}

TEST(CubeCull, eye_inside) {
    DemoRun run("cube-cull");
    run.preset("original");
    // The page's numbers: the face before the eye is in the view, the others are not.
    run.set("z-dist", 0.3).picture();
    EXPECT_EQ(run.readout("facing"), 0);
    EXPECT_EQ(run.readout("culled"), 2);
    EXPECT_EQ(run.readout("outside"), 10);
    EXPECT_EQ(run.readout("surviving"), 0);
    run.set("spin-y", 10).picture();
    EXPECT_EQ(run.readout("facing"), 0);
    EXPECT_EQ(run.readout("culled") + run.readout("outside"), 12);
    EXPECT_EQ(run.readout("surviving"), 0);
    const Picture onlyAxes = run.set("cull", "both").picture();
    EXPECT_EQ(run.set("cull", "back").picture(), onlyAxes);
    EXPECT_GT(differentPixels(run.set("cull", "front").picture(), onlyAxes), 100000);
}

TEST(CubeCull, open_shows_its_inside) {
    DemoRun run("cube-cull", 200, 200);
    const auto wrong = [&](const char* cull) {
        run.set("cull", cull).picture();
        return run.readout("wrong-pixels");
    };
    run.preset("open");
    EXPECT_EQ(wrong("none"), 0);
    const double withoutInside = wrong("back");
    EXPECT_GT(withoutInside, 10);  // the mouth of the pot alone
    // From below, no edge lets the eye in.
    run.set("spin-x", -35);
    EXPECT_LT(wrong("back"), 0.1);
    // Front faces culled, most of what is seen is an inside that should be hidden.
    run.preset("open");
    EXPECT_GT(wrong("front"), 2 * withoutInside);
    run.preset("turned");
    EXPECT_EQ(wrong("none"), 0);
    EXPECT_EQ(wrong("back"), 0);
}

TEST(CubeCull, fronts_hide_fronts) {
    DemoRun run("cube-cull", 200, 200);
    run.preset("hidden-front");
    run.picture();
    EXPECT_GT(run.readout("wrong-pixels"), 3);
    run.set("depth", "on").picture();
    // The gap under the lid's edge lets in a few lines of sight.
    EXPECT_LT(run.readout("wrong-pixels"), 0.5);
    run.set("body", "cube").set("depth", "off").picture();
    EXPECT_EQ(run.readout("wrong-pixels"), 0);
}

TEST(CubeCull, apart_as_drawn) {
    DemoRun run("cube-cull");
    // The colours of the six faces: blue, magenta, cyan, and the opposite ones
    constexpr std::array<Pixel, 6> colors{Pixel{0, 0, 255},   Pixel{255, 0, 255}, Pixel{0, 255, 255},
                                          Pixel{255, 255, 0}, Pixel{255, 0, 0},   Pixel{0, 255, 0}};
    const auto filled = [&](const Picture& picture, int left, int top, long least) {
        std::array<bool, 6> found{};
        for (std::size_t i = 0; i < colors.size(); ++i) {
            long pixels = 0;
            for (int y = top; y < top + 180; ++y)
                for (int x = left; x < left + 252; ++x) pixels += picture.at(x, y) == colors[i];
            found[i] = pixels > least;
        }
        return found;
    };
    // Where the picture has the cube, and where it has the corner
    constexpr int left = 174, top = 210, apartLeft = 348, apartTop = 420;
    for (const char* cull : {"none", "back", "front", "both"}) {
        const Picture picture = run.set("cull", cull).picture();
        std::array<bool, 6> expected = filled(picture, left, top, 1000);  // more than the axes have there
        if (std::string(cull) == "none") expected.fill(true);             // also those that are hidden
        EXPECT_EQ(filled(picture, apartLeft, apartTop, 0), expected) << cull;
    }
}

TEST(CubeCull, lines_stay) {
    DemoRun run("cube-cull");
    run.preset("original");
    const Picture picture = run.set("cull", "both").set("spin-x", 20).set("spin-y", 30).picture();
    EXPECT_EQ(run.readout("surviving"), 0);
    for (const Pixel axis : {Pixel{255, 0, 0}, Pixel{0, 255, 0}, Pixel{0, 0, 255}})
        EXPECT_GT(countPixels(picture, axis), 50);
    EXPECT_EQ(countColors(picture), 4);  // the three axes and the background
}
