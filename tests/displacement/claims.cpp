// The claims of displacement, and a test for each.
//
// - [outline-is-real] Moved vertices change the outline; the same normals without moves leave that of the smooth body.
// - [prepared-is-the-same] At a fixed level the tessellator draws what the processor's mesh of as many cells draws.
// - [no-cracks] Where neighbours agree on the levels of their edges, no pixel of the background is seen through the surface.
// - [cracks-without-agreement] Where each patch has a level of its own, some pixels of the background are seen.
// - [triangles-by-the-rule] The tessellator makes as many triangles as the levels say; patches out of view give none.
// - [left-out-changes-nothing] Patches that are left out are not in view: the picture stays byte for byte, with fewer triangles.
// - [far-needs-less] On the long wall levels by distance make a better outline of fewer triangles than a fixed level.
// - [levels-in-range] Levels beyond 64 are drawn as 64; a knob refuses 0, 65 and words that are no number.
// - [says-what-is-lacking] Without tessellation the prepared mesh is drawn, and a sentence says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "displacement/relief_patches.h"
#include "mv/error.h"
#include "mv/geometry/tessellation.h"
#include "mv/gl/beyond_es.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 320, height = 240;

// Which pixels the surface covers, as 0 and 1, the upper row first.
std::vector<float> covered(const DemoRun&) { return stage().measure(1); }
long sum(const std::vector<float>& values) { return std::count(values.begin(), values.end(), 1.0F); }
long different(const std::vector<float>& a, const std::vector<float>& b) {
    long count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
    return count;
}

// Views in which neighbours have different levels, of both bodies.
struct View {
    const char* body;
    double distance, angle, spinX, spinY, depth, fineness;
};
const std::vector<View> views{
    {"wall", 1.5, 65, 0, 0, 0.08, 64},      {"wall", 0.4, 80, 0, 0, 0.25, 20},    {"wall", 3, 30, 0, 0, 0.2, 130},
    {"wall", 0.5, 20, 0, 0, 0.25, 9},       {"orange", 1.5, 65, 20, 0, 0.08, 64}, {"orange", 0.5, 65, 20, 0, 0.2, 8},
    {"orange", 0.35, 65, 80, 30, 0.25, 12}, {"orange", 0.5, 65, -85, 0, 0.2, 30}, {"orange", 0.6, 65, 5, 185, 0.25, 16},
};
void take(DemoRun& run, const View& view) {
    run.set("body", view.body).set("distance", view.distance).set("angle", view.angle).set("depth", view.depth);
    run.set("spin-x", view.spinX).set("spin-y", view.spinY).set("fineness", view.fineness);
}

}  // namespace

TEST(DisplacementFull, outline_is_real) {
    DemoRun run("displacement", width, height);
    for (const char* body : {"wall", "orange"}) {
        run.set("body", body).set("depth", 0).set("levels", "fixed").set("level", 32);
        const auto smooth = covered(run.set("method", "tessellated"));
        run.set("depth", 0.08);
        EXPECT_EQ(covered(run.set("method", "bumped")), smooth) << body;
        const auto moved = covered(run.set("method", "tessellated"));
        // All lies below the smooth surface, and its outline is many pixels long.
        EXPECT_LT(sum(moved), sum(smooth) - 100) << body;
        // The processor's mesh knows the relief as a function. Rounding decides at the outlines of two meshes.
        const auto prepared = covered(run.set("method", "prepared"));
        EXPECT_LT(different(moved, prepared), different(smooth, prepared) / 5) << body;
    }
}

TEST(DisplacementFull, prepared_is_the_same) {
    DemoRun run("displacement", width, height);
    for (const char* body : {"wall", "orange"}) {
        run.set("body", body).set("levels", "fixed").set("map-size", 512);
        for (const int level : {4, 16, 32}) {
            run.set("level", level);
            const auto tessellated = covered(run.set("method", "tessellated"));
            const auto prepared = covered(run.set("method", "prepared"));
            // The same corners, but for the map's error, which is less than a hundredth of a pixel here, and for the way in
            // which squares are divided into triangles.
            EXPECT_LT(different(tessellated, prepared), level == 4 ? 200 : 60) << body << " " << level;
        }
    }
}

TEST(DisplacementFull, no_cracks) {
    DemoRun run("displacement", 480, 360);
    for (const View& view : views) {
        take(run, view);
        const Picture picture = run.picture();
        EXPECT_GT(countColors(picture, 50), 40);
        EXPECT_EQ(run.readout("holes"), 0) << view.body << " from " << view.distance << " " << view.fineness;
    }
}

TEST(DisplacementFull, cracks_without_agreement) {
    DemoRun run("displacement", 480, 360);
    run.set("agree", "off");
    long seenThrough = 0;
    for (const View& view : views) {
        take(run, view);
        (void)run.picture();
        seenThrough += run.readout("holes") > 0 ? 1 : 0;
    }
    EXPECT_GT(seenThrough, 4);
}

TEST(DisplacementFull, triangles_by_the_rule) {
    DemoRun run("displacement", width, height);
    const auto made = [&] {
        for (const auto& [name, count] : stage().notes().counts) {
            if (name == "triangles made") return count;
        }
        return -1.0;
    };
    for (const View& view : views) {
        take(run, view);
        (void)run.set("levels", "fixed").set("level", 13).picture();
        EXPECT_EQ(run.readout("patches") + run.readout("left-out"), 96);
        EXPECT_EQ(run.readout("triangles"), run.readout("patches") * double(trianglesOfSquare(13, 13)));
        // Each edge's level by distance is rounded up: from floats and from doubles in the same way, but where it is nearly
        // a whole number, once in many thousand.
        (void)run.set("levels", "distance").picture();
        EXPECT_GT(run.readout("triangles"), 0);
        EXPECT_NEAR(run.readout("triangles"), made(), 0.001 * made()) << view.body << " " << view.distance;
        for (const char* agree : {"off", "on"}) {
            (void)run.set("agree", agree).picture();
            EXPECT_NEAR(run.readout("triangles"), made(), 0.001 * made());
        }
    }
}

TEST(DisplacementFull, left_out_changes_nothing) {
    DemoRun run("displacement", width, height);
    long left = 0;
    for (const View& view : views) {
        take(run, view);
        const Picture with = run.set("cull", "on").picture();
        const double few = run.readout("triangles");
        left += long(run.readout("left-out"));
        const Picture without = run.set("cull", "off").picture();
        EXPECT_EQ(with, without) << view.body << " " << view.distance;
        EXPECT_EQ(run.readout("left-out"), 0);
        EXPECT_LE(few, run.readout("triangles"));
        const bool isNamed = !stage().notes().needless.empty();
        EXPECT_EQ(isNamed, few < run.readout("triangles")) << "the audit names them";
    }
    EXPECT_GT(left, 96);
}

TEST(DisplacementFull, far_needs_less) {
    DemoRun run("displacement", 640, 480);
    run.set("map-size", 512);
    for (const double angle : {55.0, 65.0, 75.0}) {
        const auto reference = covered(run.set("angle", angle).set("method", "prepared").set("level", 64));
        run.set("method", "tessellated").set("levels", "fixed").set("level", 16);
        const auto wrong = [&] {
            (void)run.picture();
            return different(covered(run), reference);
        };
        const long fixedWrong = wrong();
        const double fixedTriangles = run.readout("triangles");
        run.set("levels", "distance").set("fineness", 100);
        EXPECT_LT(wrong(), fixedWrong) << angle;
        EXPECT_LT(run.readout("triangles"), fixedTriangles) << angle;
    }
}

TEST(Displacement, levels_in_range) {
    DemoRun run("displacement", width, height);
    run.set("distance", 0.3).set("angle", 0);
    (void)run.set("levels", "fixed").set("level", 64).picture();
    EXPECT_EQ(run.readout("triangles"), run.readout("patches") * double(trianglesOfSquare(64, 64)));
    // So near, levels of hundreds are wanted.
    (void)run.set("levels", "distance").set("fineness", 512).picture();
    EXPECT_GT(edgeLevel(vec3(0), vec3(0, 0.75, 0), vec3(0, 0, 0.3), 60), largestLevel - 1);
    EXPECT_EQ(run.readout("triangles"), run.readout("patches") * double(trianglesOfSquare(64, 64)));
    EXPECT_EQ(run.readout("holes"), 0);
    for (const char* level : {"0", "65", "nan"}) EXPECT_THROW(run.demo().knob("level").parse(level), Error) << level;
    for (const char* wanted : {"0", "nan"}) EXPECT_THROW(run.demo().knob("fineness").parse(wanted), Error) << wanted;
}

TEST(DisplacementFull, says_what_is_lacking) {
    const auto says = [](DemoRun& run, const std::string& words) {
        const std::vector<std::string> messages = run.messages();
        return std::any_of(messages.begin(), messages.end(),
                           [&](const auto& message) { return message.starts_with(words); });
    };
    stage().close();
    withhold({beyond_es::tessellation});
    {
        DemoRun run("displacement", width, height);
        const Picture without = run.picture();
        EXPECT_TRUE(says(run, "This driver has no tessellation (OpenGL 4.0; asked for up to 4.6, given "));
        EXPECT_EQ(run.set("method", "prepared").picture(), without);
        EXPECT_TRUE(run.messages().empty()) << "what is not asked for is not missed";
        // Not moved, it covers what the smooth surface covers.
        const auto bumped = covered(run.set("method", "bumped"));
        EXPECT_EQ(covered(run.set("method", "prepared").set("depth", 0)), bumped);
    }
    stage().close();
    withhold({beyond_es::geometryShaders});
    {
        DemoRun run("displacement", width, height);
        const Picture without = run.set("wireframe", "on").picture();
        EXPECT_TRUE(says(run, "This driver has no geometry shaders: no edges of triangles are drawn."));
        EXPECT_EQ(run.set("wireframe", "off").picture(), without);
    }
    stage().close();
    withhold({});
}
