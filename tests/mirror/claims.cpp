// The claims of mirror, and a test for each.
//
// - [as-by-rays] Away from edges every pixel shows the object, as bright as it is, that a ray meets which every mirror on its
//   way turns round, by either method, with one bounce and with many.
// - [few-edges] Edges are at most 5 % of the picture.
// - [methods-agree] Both methods make the same picture, but for the rounding of the texture's 8 bits.
// - [stays-behind] The mirror does not show things behind it, with either near plane; without one it does.
// - [eye-in-the-plane] An eye in the mirror's plane or behind it sees nothing in it, and no pass is drawn for it.
// - [each-bounce-a-pass] Each further bounce costs each of two mirrors a pass at most, and one mirror has a single bounce.
// - [winding] A reflection reverses the winding: without the switch bodies are seen from inside.
// - [only-what-it-shows] Objects that no mirror shows are not drawn for it, and the picture is the same.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/study/study.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// One row of a study in the present settings.
StudyRow compareWithRays(int width = 480, int height = 280) {
    Study study = *stage().info().study;
    study.scenes = {{"as set", {}}};
    study.lines = {{"as set", {}}};
    study.width = width;
    study.height = height;
    StudyRow row = runStudy(stage(), study, {.timed = false}).rows.at(0);
    EXPECT_EQ(row.status, "ok");
    EXPECT_GT(double(row.awayFromEdges.n), 0.3 * width * height);  // the sky itself is not compared
    return row;
}

// The largest difference of two pictures, in levels of 255.
int largestDifference(const Picture& a, const Picture& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
    return largest;
}

const std::vector<const char*> methods{"stencil", "texture"};

}  // namespace

TEST(MirrorFull, as_by_rays) {
    DemoRun run("mirror");
    for (const char* method : methods) {
        run.set("method", method);
        for (const char* near : {"oblique", "clip-distance"}) {
            run.set("near", near).set("mirrors", "one");
            EXPECT_EQ(compareWithRays().awayFromEdges.fraction, 0) << method << ", " << near;
            run.set("mirrors", "two");
            for (const int bounces : {1, 2, 16}) {
                const StudyRow row = (run.set("bounces", bounces), compareWithRays());
                EXPECT_EQ(row.awayFromEdges.fraction, 0) << method << ", " << near << ", " << bounces;
                // In the band, the few pixels whose middle is within rounding of an edge.
                EXPECT_LT(row.all.fraction, 1e-3) << method << ", " << near << ", " << bounces;
            }
            // Mirrors at an angle, and other places of the eye
            for (const double turn : {12.0, -35.0, 70.0}) {
                run.set("mirror-turn", turn).set("eye-x", turn / 30).set("eye-height", 1.1);
                EXPECT_EQ(compareWithRays().awayFromEdges.fraction, 0) << method << ", " << near << ", " << turn;
            }
            run.set("mirror-turn", 0).set("eye-x", 0.9).set("eye-height", 1.7).set("bounces", 8);
        }
    }
    // At right angles the second mirror's image in the first is where the second one itself is: their marks must differ.
    run.set("mirrors", "two").set("mirror-turn", 90).set("eye-x", 2.9).set("eye-z", -5).set("eye-height", 1.7);
    for (const char* method : methods) {
        run.set("method", method).picture();
        EXPECT_GE(run.readout("passes"), 2);
        EXPECT_EQ(compareWithRays().awayFromEdges.fraction, 0) << method;
    }
    // Both mirrors beside each other in a wide picture
    DemoRun wide("mirror", 1500, 300);
    for (const char* method : methods) {
        wide.set("method", method)
            .set("mirrors", "two")
            .set("eye-x", -3)
            .set("eye-z", 3.2)
            .set("mirror-turn", -15)
            .picture();
        EXPECT_GT(wide.readout("passes"), 2);
        // A point of the mirrors stays there.
        EXPECT_NEAR((wide.matrix("worldFromImage1") * vec4(0, 1.2, -2, 1)).z, -2, 1e-12);
        EXPECT_NEAR((wide.matrix("worldFromImage2") * vec4(0, 1.2, 3.4, 1)).z, 3.4, 1e-12);
        EXPECT_EQ(compareWithRays(1500, 300).awayFromEdges.fraction, 0) << method;
    }
}

// The band that is left out is at most 5 % of the picture.
TEST(MirrorFull, few_edges) {
    DemoRun run("mirror");
    for (const char* mirrors : {"one", "two"}) {
        const StudyRow row = (run.set("mirrors", mirrors), compareWithRays(960, 560));
        EXPECT_LE(double(row.all.n - row.awayFromEdges.n), 0.05 * 960 * 560) << mirrors;
        EXPECT_EQ(row.awayFromEdges.fraction, 0);
    }
    // Each bounce has edges of its own: as many as there may be need a picture twice as wide.
    const StudyRow most = (run.set("bounces", 16), compareWithRays(1920, 1120));
    EXPECT_LE(double(most.all.n - most.awayFromEdges.n), 0.05 * 1920 * 1120);
    EXPECT_EQ(most.awayFromEdges.fraction, 0);
}

TEST(MirrorFull, methods_agree) {
    DemoRun run("mirror");
    for (const char* mirrors : {"one", "two"}) {
        for (const int bounces : {1, 8}) {
            run.set("mirrors", mirrors).set("bounces", bounces);
            const Picture stencil = run.set("method", "stencil").picture();
            const Picture texture = run.set("method", "texture").picture();
            // Each texture rounds by half a level, and is dimmed from then on: 0.5 (1 + r + r^2 + ...) = 0.5/(1 - 0.85),
            // and the stencil's own rounding.
            EXPECT_LE(largestDifference(stencil, texture), bounces == 1 ? 1 : 4) << mirrors << ", " << bounces;
        }
    }
}

TEST(MirrorFull, stays_behind) {
    DemoRun run("mirror");
    for (const char* method : methods) {
        run.set("method", method);
        for (const double eyeZ : {2.9, 0.0, -1.5, -1.85}) {
            run.set("eye-z", eyeZ);
            for (const char* near : {"oblique", "clip-distance"}) {
                run.set("near", near).picture();
                EXPECT_EQ(run.readout("from-behind"), 0) << method << ", " << near << ", " << eyeZ;
            }
        }
        run.set("eye-z", 2.9).set("near", "none").picture();
        EXPECT_GT(run.readout("from-behind"), 1000) << method;
        // A ball that is half in the mirror: what is behind is cut off, whatever way.
        run.set("ball-z", -2).set("ball-x", -0.6);
        const Picture oblique = run.set("near", "oblique").picture();
        EXPECT_LE(differentPixels(oblique, run.set("near", "clip-distance").picture()), 20) << "but for rounding";
        EXPECT_GT(differentPixels(oblique, run.set("near", "none").picture()), 1000);
        run.set("ball-z", -0.35).set("ball-x", -0.35);
    }
}

// X55
TEST(MirrorFull, eye_in_the_plane) {
    DemoRun run("mirror");
    for (const char* method : methods) {
        for (const char* near : {"oblique", "clip-distance"}) {
            run.set("method", method).set("near", near);
            // In the plane, beside it and turned, and behind
            for (const auto& [x, z, turn] : {std::tuple{2.5, -2.0, 0.0},
                                             {-2.9, -2.0, 0.0},
                                             {2.0, -2.0, 180.0},
                                             {2.0, 0.0, -45.0},
                                             {1.0, -4.0, 0.0},
                                             {0.5, 2.9, 150.0}}) {
                run.set("eye-x", x).set("eye-z", z).set("mirror-turn", turn).picture();
                EXPECT_EQ(run.readout("passes"), 0) << x << ", " << z << ", " << turn;
                EXPECT_EQ(run.readout("drawn"), 0);
                EXPECT_LT(run.readout("eye-distance"), 1e-12);
                ASSERT_EQ(run.messages().size(), 1U);
                EXPECT_EQ(run.messages()[0], "The eye is not in front of the first mirror: nothing is seen in it.");
                EXPECT_EQ(compareWithRays().awayFromEdges.fraction, 0) << x << ", " << z << ", " << turn;
            }
            // As soon as it is in front there is an image, right by rays.
            run.set("eye-x", 2.5).set("eye-z", -1.9).set("mirror-turn", 0).picture();
            EXPECT_EQ(run.readout("passes"), 1);
            EXPECT_EQ(compareWithRays().awayFromEdges.fraction, 0);
        }
    }
}

TEST(MirrorFull, each_bounce_a_pass) {
    DemoRun run("mirror");
    for (const char* method : methods) {
        run.set("method", method).set("mirrors", "one").set("bounces", 16).picture();
        EXPECT_EQ(run.readout("passes"), 1);
        run.set("mirrors", "two");
        for (const int bounces : {1, 2, 3, 16}) {
            run.set("bounces", bounces).picture();
            EXPECT_EQ(run.readout("passes"), bounces) << method;  // the second mirror is behind this eye
        }
    }
    DemoRun wide("mirror", 1500, 300);
    wide.set("mirrors", "two").set("eye-x", -3).set("eye-z", 3.2).set("mirror-turn", -15);
    double before = 0;
    for (int bounces = 1; bounces <= 6; ++bounces) {
        wide.set("bounces", bounces).picture();
        EXPECT_LE(wide.readout("passes"), before + 2);
        before = wide.readout("passes");
    }
}

TEST(Mirror, winding) {
    DemoRun run("mirror");
    const StudyRow turned = compareWithRays(), left = (run.set("winding", "off"), compareWithRays());
    EXPECT_EQ(turned.awayFromEdges.fraction, 0);
    EXPECT_GT(left.awayFromEdges.fraction, 0.02);
    // The floor has one side alone, which is culled then.
    run.picture();
    EXPECT_GT(run.readout("wrong"), 2);
}

TEST(MirrorFull, only_what_it_shows) {
    DemoRun run("mirror");
    for (const char* method : methods) {
        for (const char* mirrors : {"one", "two"}) {
            for (const double turn : {0.0, 30.0}) {
                run.set("method", method).set("mirrors", mirrors).set("mirror-turn", turn);
                const Picture few = run.set("leave-out", "on").picture();
                const double drawn = run.readout("drawn"), leftOut = run.readout("left-out");
                const Picture all = run.set("leave-out", "off").picture();
                EXPECT_EQ(differentPixels(few, all), 0) << method << ", " << mirrors << ", " << turn;
                if (turn == 0) {
                    EXPECT_GT(leftOut, 0);
                }
                EXPECT_EQ(run.readout("drawn"), drawn + leftOut);
            }
        }
    }
}
