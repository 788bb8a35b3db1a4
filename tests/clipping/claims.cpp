// The claims of clipping, and a test for each; X25 in docs/stability.md is its extreme.
//
// - [nine-codes] The code of a point says beyond which sides it lies; OR and AND of two codes are right about their segment.
// - [same-on-paper] All four methods agree on whole numbers that they can compute without rounding.
// - [decided-by-luck] Only the exact method decides all segments aimed at a corner rightly, and ends within 4 ulp.
// - [one-piece-too-many] Of a concave polygon in two pieces Sutherland and Hodgman's method makes one, with edges on each
//   other; its area is right, and the other method's pieces have the same.
// - [sides-do-not-close] Sides clipped as segments are right one by one, and have no area together.
// - [unit-normal] A half plane's product with a point is its distance where the normal is 1 long, as of a window, not where all three
//   numbers are; of a polygon's edge it is the distance times the edge's length.
// - [inside-out] Clipping after the division shows the wrong part of a segment that goes from before the eye to behind it;
//   clipping before the projection or before the division shows the right part, the same in both.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "clipping/clip_methods.h"
#include "clipping/clipping.h"
#include "mv/geometry/clip_segment.h"
#include "support/demo_run.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

const Box window{{-1.6, -1}, {1.5, 1.2}};

DemoRun smallRun() { return DemoRun("clipping", 240, 140); }

std::optional<Segment> byCodes(const Segment& segment, const Box& box) {
    const CodeRound last = cohenSutherland(segment, box).back();
    return last.does == CodeRound::Does::accept ? std::optional(last.segment) : std::nullopt;
}

}  // namespace

TEST(Clipping, nine_codes) {
    Random random(25);
    int accepted = 0, rejected = 0;
    for (int i = 0; i < 20000; ++i) {
        const Segment segment{vec2(random.point(3)), vec2(random.point(3))};
        const unsigned a = regionCode(window, segment.a), b = regionCode(window, segment.b);
        EXPECT_EQ((a & above) != 0, segment.a.y > window.high.y);
        EXPECT_EQ((a & below) != 0, segment.a.y < window.low.y);
        EXPECT_EQ((a & rightOf) != 0, segment.a.x > window.high.x);
        EXPECT_EQ((a & leftOf) != 0, segment.a.x < window.low.x);
        const auto part = clipSegment(segment, window);
        if ((a | b) == 0) {
            ASSERT_EQ(part, segment);
            ++accepted;
        }
        if ((a & b) != 0) {
            ASSERT_FALSE(part);
            ++rejected;
        }
        // Each round's cut leaves the code without the bit that it was cut for.
        const auto rounds = cohenSutherland(segment, window);
        ASSERT_LE(rounds.size(), 5U);
        for (std::size_t k = 1; k < rounds.size(); ++k) {
            const CodeRound& before = rounds[k - 1];
            EXPECT_EQ((before.cutsA ? rounds[k].codeA : rounds[k].codeB) & before.side, 0U);
        }
    }
    EXPECT_GT(accepted, 500);
    EXPECT_GT(rejected, 1000);
    EXPECT_EQ(codeText(above | leftOf), "1001");
}

// Steps of whole numbers in which every division comes out even: then nothing is rounded, and paper and machine agree.
TEST(Clipping, same_on_paper) {
    const Box box{{-4, -4}, {4, 4}};
    int kept = 0;
    for (int ax = -8; ax <= 8; ax += 4) {
        for (int ay = -8; ay <= 8; ++ay) {
            for (int bx = -8; bx <= 8; bx += 16) {
                for (int by = -8; by <= 8; by += 4) {
                    const Segment segment{{ax, ay}, {bx, by}};
                    const vec2 along = glm::abs(segment.b - segment.a);
                    const auto even = [](double n) { return n == 0 || std::exp2(std::round(std::log2(n))) == n; };
                    if (!even(along.x) || !even(along.y)) continue;
                    const auto exact = clipSegment(segment, box);
                    ASSERT_EQ(byCodes(segment, box), exact);
                    ASSERT_EQ(liangBarsky(segment, box), exact);
                    ASSERT_EQ(cyrusBeck(segment, halfPlanes(box)), exact);
                    ASSERT_EQ(clipExactly(segment, box, 10).meets, exact.has_value());
                    kept += exact ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(kept, 50);
}

TEST(ClippingFull, decided_by_luck) {
    // A million segments at four distances from the origin, and windows of several shapes
    for (const double offset : {0.0, 1.0, 1e3, 1e6}) {
        for (const vec2 size : {vec2(3.1, 2.2), vec2(1, 1), vec2(0.01, 5)}) {
            const Box box = exactWindow({vec2(-1.6, -1) + offset, vec2(-1.6, -1) + offset + size});
            const auto segments = aimedAtCorners(box, 83334);
            const Trial exact =
                tryMethod([](const auto& s, const auto& b) { return clipSegment(s, b); }, segments, box);
            EXPECT_EQ(exact.wrongPercent, 0);
            EXPECT_LE(exact.ulps, 4);
            const Trial codes = tryMethod(byCodes, segments, box);
            EXPECT_GT(codes.wrongPercent, 0.1) << offset << " " << size.x;
        }
    }
    // The demo reads out the same
    DemoRun run = smallRun();
    (void)run.set("method", "exact").picture();
    EXPECT_EQ(run.readout("wrong"), 0);
    EXPECT_LE(run.readout("end-error"), 4);
    for (const std::string method : {"cohen-sutherland", "liang-barsky", "cyrus-beck"}) {
        (void)run.set("method", method).picture();
        EXPECT_GT(run.readout("wrong"), 1) << method;
    }
}

TEST(Clipping, one_piece_too_many) {
    DemoRun run = smallRun();
    (void)run.preset("concave").picture();
    const double together = run.readout("area");
    (void)run.preset("pieces").picture();
    EXPECT_NEAR(run.readout("area"), together, 1e-13) << "some roundings of areas of 3";
    // The U's two arms, each by itself
    (void)run.set("polygon", "-2.4,-2/-1.2,-2/-1.2,2/-2.4,2").picture();
    const double left = run.readout("area");
    (void)run.set("polygon", "2.4,-2/1.2,-2/1.2,2/2.4,2").picture();
    EXPECT_NEAR(left + run.readout("area"), together, 1e-13);
    // The method refuses what it cannot do.
    run.preset("concave").set("against", "-2,-1/2,-1/0,0/2,1/-2,1");
    EXPECT_EQ(run.refusal(), "--against: must be convex with --polygon-method sutherland-hodgman; overlap takes any");
    run.preset("pieces").set("against", "-2,-1/2,-1/0,0/2,1/-2,1");
    EXPECT_EQ(run.refusal(), "");
    run.set("polygon", "0,0/1,1/1,0/0,1");
    EXPECT_EQ(run.refusal(), "--polygon: must have an area, and edges that do not cross or touch");
}

TEST(Clipping, inside_out) {
    DemoRun run = smallRun();
    run.preset("inside-out");
    (void)run.picture();
    EXPECT_GT(run.readout("off"), 0.3) << "a sixth of the picture";
    for (const std::string where : {"view", "clip"}) {
        (void)run.set("where", where).picture();
        EXPECT_LT(run.readout("off"), 1e-14 * 8) << where << ": roundings of a projection and its inverse order";
    }
    // Wholly before the eye, dividing first does no harm; wholly behind it, it shows what nobody sees.
    run.set("where", "divided").set("in-space", "-0.8,-2.4/0.5,-1");
    (void)run.picture();
    EXPECT_LT(run.readout("off"), 1e-14 * 8);
    run.set("in-space", "-0.3,1/0.3,1.2");
    (void)run.picture();
    EXPECT_EQ(run.readout("off"), 2) << "nothing is seen, and a segment is shown";
    (void)run.set("where", "clip").picture();
    EXPECT_EQ(run.readout("off"), 0);
}

TEST(Clipping, sides_do_not_close) {
    clipping::Settings s{.subject = clipping::Subject::polygon, .polygons = {.method = clipping::PolygonMethod::sides}};
    const auto sides = piecesOf(s);
    ASSERT_EQ(sides.size(), 2U);  // the inner sides of the two bars: the others are beyond the window
    for (const auto& side : sides) {
        ASSERT_EQ(side.size(), 2U);
        for (const vec2& end : side) {
            // Inside, and at the window's outline: no end is another's. 1e-9 is far more than rounds, far less than the grid
            double least = 1;
            for (const HalfPlane& half : halfPlanes(s.polygons.against)) least = std::min(least, half.of(end));
            EXPECT_NEAR(least, 0, 1e-9);
            int same = 0;
            for (const auto& other : sides) {
                for (const vec2& at : other) same += glm::distance(at, end) < 1e-9;
            }
            EXPECT_EQ(same, 1);
        }
    }
    EXPECT_EQ(clipping::areaOf(sides), 0);
    s.polygons.method = clipping::PolygonMethod::overlap;
    EXPECT_GT(clipping::areaOf(piecesOf(s)), 1);
}

TEST(Clipping, unit_normal) {
    // A window's normals are 1 long: the four products are the distances from its sides.
    const Box box{{3, -1}, {5, 2}};
    const auto sides = halfPlanes(box);
    for (const vec2& p : {vec2(4, 0), vec2(1, 7), vec2(5.5, -2.25)}) {
        const std::array<double, 4> distances{p.x - 3, 5 - p.x, p.y + 1, 2 - p.y};
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(sides.at(i).of(p), distances.at(i));
        // The slide's is something else of all three numbers together: on the line x = 3 the root of 10 divides.
        const HalfPlane& left = sides[0];
        const double length = std::hypot(left.normal.x, left.normal.y, left.distance);
        EXPECT_NEAR(left.of(p) / length, (p.x - 3) / std::sqrt(10), 1e-15);  // three roundings of numbers of 1
    }
    // An edge's normal is as long as the edge. From (2, 1) to (-2, 4) it is 5, and across it the unit vector is (0.6, 0.8).
    for (const bool turned : {false, true}) {
        std::vector<vec2> corners{{2, 1}, {6, 6}, {-2, 4}};  // (6, 6) is the inner side
        if (turned) std::reverse(corners.begin(), corners.end());
        const HalfPlane edge = halfPlanes(corners).at(2);
        EXPECT_EQ(glm::length(edge.normal), 5);
        for (const double distance : {-10.0, -5.0, 0.0, 5.0}) {
            const vec2 p(2 + distance * 3 / 5, 1 + distance * 4 / 5);
            EXPECT_EQ(edge.of(p), 5 * distance) << turned;
        }
    }
}
