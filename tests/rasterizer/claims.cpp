// The claims of rasterizer, and a test for each.
//
// - [within-half-a-pixel] Bresenham's method sets in each column, or row, the pixel nearest to the line, in all octants.
// - [four-steps-to-it] From line to line of the lecture's improvements only the unit of the error changes, not a pixel, as long as
//   floats are exact.
// - [same-coverage] Brute force, box, adding up and tiles cover the same pixels, and ask fewer pixels each.
// - [no-hole-no-double] Two triangles with a common edge share no pixel, and leave out none between them.
// - [as-opengl] OpenGL's driver covers the same pixels where no clipping cuts the triangle.
// - [divided-by-w] Colours weighted by the corners' parts of the picture are not those of the surface; over w they are.
// - [eight-leaks] A fill with 8 neighbours leaks through the outline of Bresenham's method, one with 4 does not.
// - [ends-and-refuses] A fill into its own colour ends, and recursion that would end the stack is refused.
// - [as-thick] A line of columns has its thickness times the cosine of its slope; a line filled across has it at every slope.
// - [circle-nearest] In each column of an eighth, and in each row of the next one, the midpoint method sets the nearest pixel, and no
//   pixel twice; a square root in float, mirrored, sets the same ones.
// - [circle-gaps] One pixel a column leaves gaps in a circle; its eighths mirrored, or a point turned round, leave none.
// - [one-decides] Of a line that is not whole the pixel set last is framed, and the bar below lies to the right of 0 where the line
//   steps up, and else to the left.
// - [one-by-one] A key takes away one of all pixels, however many there are, and the picture counts them.
// - [two-insides] A star's middle is outside by even and odd, and inside by how often the outline winds round it.
// - [share-of-a-pixel] Where edges are sampled, a pixel that no edge crosses is as it was, and one at an edge has a mean of colours: OpenGL's own
//   (llvmpipe). Of four places its share is off by less than half as much as of one, against the exact area; an edge along
//   the pixels' borders is as sharp as before.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/preset.h"
#include "mv/error.h"
#include "mv/math/clip.h"
#include "rasterizer/circle.h"
#include "rasterizer/fill.h"
#include "rasterizer/line.h"
#include "rasterizer/rasterizer.h"
#include "rasterizer/sheet.h"
#include "rasterizer/trials.h"
#include "shared/raster_triangle.h"
#include "support/demo_run.h"
#include "support/random.h"
#include "support/softpipe.h"

using namespace mv;
using namespace mv::test;

namespace {

using Corners = std::array<vec2, 3>;

std::vector<std::pair<int, int>> placesOf(const std::vector<PixelStep>& pixels) {
    std::vector<std::pair<int, int>> places;
    for (const PixelStep& pixel : pixels) places.emplace_back(pixel.x, pixel.y);
    return places;
}

vec2 cornerOf(Random& random, double width, double height) {
    const double x = std::round(random.number(0, width) * subPixels) / subPixels;
    return {x, std::round(random.number(0, height) * subPixels) / subPixels};
}

// The middle of a pixel, with 1 for a third coordinate: the weights of three such corners solve a system.
bool isIn(const vec3& weights) { return std::min({weights.x, weights.y, weights.z}) >= 0; }

}  // namespace

TEST(RasterizerFull, within_half_a_pixel) {
    for (int x = -40; x <= 40; ++x) {
        for (int y = -40; y <= 40; ++y) {
            const auto pixels = linePixels(LineMethod::octants, 3, -2, 3 + x, -2 + y);
            const int run = std::max(std::abs(x), std::abs(y));
            ASSERT_EQ(pixels.size(), static_cast<std::size_t>(run + 1));
            const bool steep = std::abs(y) > std::abs(x);
            std::set<int> along;
            bool touchesStart = false, touchesEnd = false;
            for (const PixelStep& pixel : pixels) {
                const int dx = pixel.x - 3, dy = pixel.y + 2;
                along.insert(steep ? dy : dx);
                // |dy - dx y/x| <= 1/2, times 2 |x|: no division, no rounding
                const int off = steep ? std::abs(2 * (dx * y - dy * x)) : std::abs(2 * (dy * x - dx * y));
                ASSERT_LE(off, run) << x << " " << y;
                touchesStart |= dx == 0 && dy == 0;
                touchesEnd |= dx == x && dy == y;
            }
            ASSERT_EQ(along.size(), pixels.size()) << "one a column, or a row";
            ASSERT_TRUE(touchesStart && touchesEnd);
            // From the first end, pixel by pixel, and back by the same ones
            auto there = placesOf(pixels);
            ASSERT_EQ(there.front(), std::pair(3, -2)) << x << " " << y;
            for (std::size_t i = 1; i < there.size(); ++i) {
                const int dx = there[i].first - there[i - 1].first, dy = there[i].second - there[i - 1].second;
                ASSERT_EQ(std::max(std::abs(dx), std::abs(dy)), 1) << x << " " << y;
            }
            std::ranges::reverse(there);
            ASSERT_EQ(there, placesOf(linePixels(LineMethod::octants, 3 + x, -2 + y, 3, -2))) << x << " " << y;
            // Two pixels a column by nearness, and these in the same order
            const auto fine = linePixels(LineMethod::smooth, 3, -2, 3 + x, -2 + y),
                       back = linePixels(LineMethod::smooth, 3 + x, -2 + y, 3, -2);
            ASSERT_EQ(std::pair(fine.front().x, fine.front().y), std::pair(3, -2)) << x << " " << y;
            ASSERT_EQ(std::pair(fine.back().x, fine.back().y), std::pair(3 + x, -2 + y)) << x << " " << y;
            std::set<std::tuple<int, int, double>> ofFine, ofBack;
            for (const PixelStep& pixel : fine) ofFine.emplace(pixel.x, pixel.y, pixel.coverage);
            for (const PixelStep& pixel : back) ofBack.emplace(pixel.x, pixel.y, pixel.coverage);
            ASSERT_EQ(ofFine, ofBack) << x << " " << y;
        }
    }
    // Each pixel has its colour by nearness: each column's two pixels share the colour, and their middle is the line.
    for (const PixelStep& pixel : linePixels(LineMethod::smooth, 0, 0, 7, 3)) EXPECT_GT(pixel.coverage, 0);
    const auto heights = lineTest(LineMethod::smooth, 96), truth = lineTruth(96);
    for (std::size_t i = 0; i < truth.size(); ++i) ASSERT_NEAR(heights[i], truth[i], 1e-12);
}

TEST(Rasterizer, four_steps_to_it) {
    for (int x = 1; x <= 64; x *= 2) {  // 1/x is a float
        for (int y = 0; y <= x; ++y) {
            const auto last = placesOf(linePixels(LineMethod::bresenham, 0, 0, x, y));
            for (const LineMethod method :
                 {LineMethod::error, LineMethod::shifted, LineMethod::scaled, LineMethod::octants})
                ASSERT_EQ(placesOf(linePixels(method, 0, 0, x, y)), last) << x << " " << y;
        }
    }
    // Floats that add up err where 1/x is none of them, and whole numbers do not.
    const auto truth = lineTruth(6000);
    const auto wrong = [&](LineMethod method) {
        const auto heights = lineTest(method, 6000);
        int count = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) count += std::abs(heights[i] - truth[i]) > 0.5 ? 1 : 0;
        return count;
    };
    EXPECT_EQ(wrong(LineMethod::bresenham), 0);
    EXPECT_EQ(wrong(LineMethod::scaled), 0);
    EXPECT_GT(wrong(LineMethod::naive), 100);
    // The error since the last step stays below 1, and so do its roundings' sizes: 2^-25 each.
    EXPECT_LT(wrong(LineMethod::error), wrong(LineMethod::naive) / 10);
    // The lecture's are made for one octant: the error term never goes up by 2, so steep lines end too low.
    const auto steep = linePixels(LineMethod::bresenham, 0, 0, 3, 9);
    EXPECT_EQ(steep.back().y, 3);
    EXPECT_TRUE(linePixels(LineMethod::bresenham, 5, 0, 2, 1).empty());
}

TEST(Rasterizer, same_coverage) {
    Random random(12);
    double askedBrute = 0, askedBox = 0, askedTiles = 0;
    for (int i = 0; i < 300; ++i) {
        const double reach = i % 3 == 0 ? 1.5 : 1;  // some hang over the edges
        const Corners corners{cornerOf(random, 64 * reach, 48 * reach), cornerOf(random, 64, 48),
                              cornerOf(random, 64, 48 * reach)};
        const auto sorted = [&](FillMethod method) {
            auto places = placesOf(coveredPixels(corners, 64, 48, method).pixels);
            std::sort(places.begin(), places.end());
            return places;
        };
        const auto brute = sorted(FillMethod::brute);
        for (const FillMethod method : {FillMethod::box, FillMethod::incremental, FillMethod::tiles})
            ASSERT_EQ(sorted(method), brute) << i;
        askedBrute += double(coveredPixels(corners, 64, 48, FillMethod::brute).asked);
        askedBox += double(coveredPixels(corners, 64, 48, FillMethod::box).asked);
        askedTiles += double(coveredPixels(corners, 64, 48, FillMethod::tiles).asked);
    }
    EXPECT_LT(askedBox, askedBrute);
    EXPECT_LT(askedTiles, askedBox);
    // And what is right is found by another way: by crossings of the rows.
    EXPECT_EQ(triangleTest(FillMethod::box, 96, 72), triangleTruth(96, 72));
}

TEST(Rasterizer, no_hole_no_double) {
    Random random(23);
    // Fans round corners in the middle of pixels, so that many middles lie on edges
    for (int i = 0; i < 200; ++i) {
        const auto corner = [&] {
            const double x = std::floor(random.number(0, 40)) + 0.5;
            return vec2(x, std::floor(random.number(0, 30)) + 0.5);
        };
        const vec2 a = corner(), b = corner(), c = corner(), d = corner();
        const auto area = [](const vec2& p, const vec2& q, const vec2& r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        if (area(a, b, c) <= 0 || area(a, c, d) <= 0) continue;  // on both sides of a c
        const auto together = [&](EdgeRule rule) {
            std::vector<std::pair<int, int>> all =
                placesOf(coveredPixels({a, b, c}, 40, 30, FillMethod::box, rule).pixels);
            const auto other = placesOf(coveredPixels({a, c, d}, 40, 30, FillMethod::box, rule).pixels);
            all.insert(all.end(), other.begin(), other.end());
            return all;
        };
        const auto right = together(EdgeRule::bottomLeft);
        ASSERT_EQ(std::set(right.begin(), right.end()).size(), right.size()) << "a pixel twice";
        // Between the two: every middle on the common edge, without its ends, is some triangle's
        const std::set<std::pair<int, int>> drawn(right.begin(), right.end());
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                const vec2 middle(x + 0.5, y + 0.5);
                const bool within =
                    (isIn(cornerWeights({a, b, c}, middle)) && area(a, b, middle) > 0 && area(b, c, middle) > 0) ||
                    (isIn(cornerWeights({a, c, d}, middle)) && area(c, d, middle) > 0 && area(d, a, middle) > 0);
                if (!within) continue;
                ASSERT_EQ(drawn.count({x, y}), 1U) << "a hole";
            }
        }
    }
    DemoRun run("rasterizer");
    run.preset("shared-edge").picture();
    EXPECT_EQ(run.readout("doubles"), 0);
    EXPECT_EQ(run.readout("holes"), 0);
    run.set("corners", "4.5,3.5/20.5,3.5/20.5,15.5/4.5,15.5");
    for (const auto& [rule, doubles, holes] :
         {std::tuple("bottom-left", 0, 0), std::tuple("inside", 5, 0), std::tuple("outside", 0, 5)}) {
        (void)run.set("rule", rule).picture();
        // The diagonal, 16 by 12, goes through every fourth middle of a column: 3 between its ends, which are corners of both.
        EXPECT_EQ(run.readout("doubles") > 0, doubles > 0) << rule;
        EXPECT_EQ(run.readout("holes") > 0, holes > 0) << rule;
    }
}

// How many pixels of 24 by 18 units have their middle on a line between two of the corners, where OpenGL leaves it to the driver
// which of the two triangles beside it has them.
static int onAnEdge(const std::vector<vec2>& corners, int across) {
    int count = 0;
    for (int y = 0; y < across * 18 / 24; ++y) {
        for (int x = 0; x < across; ++x) {
            const vec2 middle = vec2(x + 0.5, y + 0.5) * 24.0 / static_cast<double>(across);
            bool is = false;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                for (std::size_t k = 0; k < i; ++k) {
                    const vec2 along = corners[k] - corners[i], to = middle - corners[i];
                    is = is || along.x * to.y == along.y * to.x;  // exact: sixteenths of a unit
                }
            }
            count += is;
        }
    }
    return count;
}

TEST(RasterizerFull, as_opengl) {
    Random random(7);
    DemoRun run("rasterizer", 480, 220);
    run.set("subject", "triangle");
    for (int i = 0; i < 60; ++i) {
        std::string corners;
        std::vector<vec2> places;
        for (int k = 0; k < 4; ++k) {
            const double x = std::round(random.number(0, 24) * 16) / 16, y = std::round(random.number(0, 18) * 16) / 16;
            corners += (k == 0 ? "" : "/") + numberText(x) + "," + numberText(y);
            places.emplace_back(x, y);
        }
        const int across = i % 3 == 0 ? 24 : 96;
        run.set("corners", corners).set("neighbour", i % 2 == 0 ? "on" : "off").set("cells", across);
        run.set("shade", i % 5 == 0 ? "surface" : "flat").picture();
        ASSERT_LE(run.readout("differs"), onLlvmpipe() ? 0 : onAnEdge(places, across)) << corners;
    }
    // A line leaves out its last pixel, by the rule of diamonds. Where it lies half-way between two pixels OpenGL lets the driver
    // choose, and its own line may be one pixel beside the ideal one everywhere.
    run.preset("bresenham").picture();
    EXPECT_GE(run.readout("differs"), 1);
    EXPECT_LE(run.readout("differs"), onLlvmpipe() ? 1 : HUGE_VAL);
}

TEST(RasterizerFull, share_of_a_pixel) {
    DemoRun run("rasterizer", 480, 220);
    if (hasOneSample()) return;
    run.set("subject", "triangle").set("step", 999);
    for (const char* corners :
         {"2.25,3.5/20.5,1.5/21.5,14.25/6.5,16.5", "1.0625,1/23,2.9375/18,17/2,9.5", "0,0/24,0.5/24,18/0.25,18"}) {
        for (const int cells : {24, 96}) {
            // Where a pixel's places lie is the driver's choice. A cell may then differ where one of five edges meets it, and an edge
            // meets at most as many cells as there are columns and rows
            const int met = 5 * (cells + cells * 18 / 24);
            run.set("corners", corners).set("cells", cells).set("edges", "sampled").set("places", 4).picture();
            const double four = run.readout("edge-error");
            EXPECT_LE(run.readout("differs"), onLlvmpipe() ? 0 : met) << corners << ", " << cells;
            run.set("places", 1).picture();
            EXPECT_LT(four, 0.5 * run.readout("edge-error")) << corners << ", " << cells;
            EXPECT_GT(four, 0.02) << "sixteenths of a pixel are not told by fourths";
        }
    }
    // One place is the middle, and that is a hard edge
    stage().resize(960, 440);
    run.set("corners", "4,3/20,3/20,15/4,15").set("cells", 24);
    const Picture hard = run.set("edges", "hard").picture();
    // Within the sheet of 456 x 342 pixels, above the words; the ends of the drawn edges hide no pixel's middle
    const auto middle = [](const Picture& picture, int x, int y) {
        return picture.at(8 + 19 * x + 9, 8 + 19 * (17 - y) + 5);
    };
    run.set("edges", "sampled").set("places", 4).set("neighbour", "off");
    const Picture sampled = run.picture(), alone = run.set("edges", "hard").picture();
    int partly = 0;
    for (int y = 0; y < 18; ++y) {
        for (int x = 0; x < 24; ++x) {
            const bool isCrossed = x >= 4 && x < 20 && y >= 3 && y < 15 && std::abs(12 * (x - 4) - 16 * (y - 3)) < 16;
            if (!isCrossed) {
                EXPECT_TRUE(sameColor(middle(sampled, x, y), middle(alone, x, y))) << x << ", " << y;
            }
            partly += sameColor(middle(sampled, x, y), middle(alone, x, y)) ? 0 : 1;
            if (!onLlvmpipe()) continue;
            // OpenGL's pane is 480 pixels to the right
            EXPECT_TRUE(sameColor(middle(sampled, x, y), sampled.at(488 + 19 * x + 9, 8 + 19 * (17 - y) + 5)))
                << x << ", " << y;
        }
    }
    EXPECT_GT(partly, 8) << "along the slope";
    EXPECT_NE(hard, alone);
}

TEST(Rasterizer, divided_by_w) {
    const Corners corners{vec2(0, 0), vec2(8, 0), vec2(0, 8)};
    const vec3 w(1, 4, 2);
    for (const vec2& at : {vec2(2, 2), vec2(0.5, 6.5), vec2(4, 4)}) {
        const vec3 weights = cornerWeights(corners, at), surface = perspectiveWeights(weights, w);
        EXPECT_NEAR(surface.x + surface.y + surface.z, 1, 4e-16);
        // The surface's point (sum of weights times w times corner, sum of weights times w) divides to the pixel.
        const double below = glm::dot(surface, w);
        vec2 shown(0);
        for (int i = 0; i < 3; ++i) shown += surface[i] * w[i] * corners.at(static_cast<std::size_t>(i));
        EXPECT_LT(glm::distance(shown / below, at), 1e-14);
    }
    EXPECT_LT(glm::distance(perspectiveWeights({0.2, 0.3, 0.5}, vec3(3)), vec3(0.2, 0.3, 0.5)), 4e-16)
        << "where all w are one";
    // OpenGL's colours are those over w, up to the rounding of its floats and of 8 bits.
    DemoRun run("rasterizer", 960, 440);
    const auto largest = [&] {
        const Picture picture = run.picture();
        int most = 0;
        for (int y = 0; y < 330; ++y) {
            for (int x = 12; x < 460; x += 6) {
                const Pixel a = picture.at(x, y), b = picture.at(x + 480, y);
                most =
                    std::max({most, std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
            }
        }
        return most;
    };
    run.preset("surface");
    EXPECT_LE(largest(), 1);
    run.set("shade", "picture");
    EXPECT_LE(largest(), 1);
    const Picture inPicture = run.picture();
    EXPECT_GT(differentPixels(inPicture, run.set("shade", "surface").picture()), 10000);
}

TEST(Rasterizer, eight_leaks) {
    DemoRun run("rasterizer", 480, 220);
    (void)run.preset("leak").set("neighbours", 4).picture();
    const double inside = run.readout("set");
    (void)run.set("neighbours", 8).picture();
    EXPECT_GT(run.readout("set"), inside + 100);
    // Both ways to fill set the same pixels.
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        PixelMap map(32, 24);
        for (int& color : map.colors) color = random.number(0, 1) < 0.35 ? 1 : 0;
        const int x = static_cast<int>(random.number(0, 32)), y = static_cast<int>(random.number(0, 24));
        for (const int neighbors : {4, 8}) {
            PixelMap one = map, other = map;
            const Flooded a = floodByRecursion(one, x, y, 2, neighbors), b = floodBySpans(other, x, y, 2, neighbors);
            ASSERT_EQ(one.colors, other.colors) << neighbors;
            ASSERT_EQ(a.pixels.size(), b.pixels.size());
            // Whatever has the seed's colour and a neighbour that was filled is filled.
            for (int j = 0; j < 24; ++j) {
                for (int k = 0; k < 31; ++k) {
                    if (map.at(k, j) != map.at(x, y) || map.at(k + 1, j) != map.at(x, y)) continue;
                    ASSERT_EQ(one.at(k, j), one.at(k + 1, j));
                }
            }
        }
    }
}

TEST(Rasterizer, ends_and_refuses) {
    PixelMap map(300, 300);
    EXPECT_EQ(floodBySpans(map, 5, 5, 0, 4).pixels.size(), 0U) << "into its own colour";
    EXPECT_EQ(floodByRecursion(map, 5, 5, 0, 4).pixels.size(), 0U);
    EXPECT_EQ(floodBySpans(map, -1, 5, 2, 4).pixels.size(), 0U) << "beyond the picture";
    PixelMap deep = map;
    try {
        (void)floodByRecursion(deep, 0, 0, 2, 4);
        FAIL() << "90000 calls deep";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "floodByRecursion: must not go deeper than 20000 calls, or the stack ends: fill by spans");
    }
    const Flooded spans = floodBySpans(map, 0, 0, 2, 4);
    EXPECT_EQ(spans.pixels.size(), 90000U);
    EXPECT_LE(spans.deepest, 2);
    // In the demo the same sentence, and the way out of it.
    DemoRun run("rasterizer", 200, 100);
    run.set("subject", "fill").set("cells", "384").set("neighbours", 8).set("flood", "recursive");
    EXPECT_THROW((void)run.picture(), Error);
    (void)run.set("flood", "spans").picture();
    EXPECT_GT(run.readout("set"), 20000);
}

TEST(Rasterizer, as_thick) {
    for (const auto& way : {std::pair(200, 0), std::pair(200, 100), std::pair(-200, 200), std::pair(60, -200)}) {
        const int x = way.first, y = way.second;
        const double length = std::hypot(x, y), cosine = std::max(std::abs(x), std::abs(y)) / length;
        for (const int thickness : {2, 5, 9}) {
            const auto thick = [&](Thicken thicken) {
                const auto pixels = thickLine(LineMethod::octants, thicken, thickness, 300, 300, 300 + x, 300 + y);
                const auto places = placesOf(pixels);
                EXPECT_EQ(std::set(places.begin(), places.end()).size(), places.size()) << "a pixel twice";
                return double(pixels.size()) / length;
            };
            // A column at each end is one pixel of the length, and the area's pixels differ from it by those of its outline at most.
            EXPECT_NEAR(thick(Thicken::columns), thickness * cosine, thickness / length * 1.5);
            EXPECT_NEAR(thick(Thicken::across), thickness, (2 * length + 2 * thickness) / length * 0.25);
        }
    }
    EXPECT_EQ(placesOf(thickLine(LineMethod::octants, Thicken::across, 1, 0, 0, 9, 4)),
              placesOf(linePixels(LineMethod::octants, 0, 0, 9, 4)));
    EXPECT_TRUE(thickLine(LineMethod::octants, Thicken::across, 5, 3, 3, 3, 3).empty()) << "without a length";
    // OpenGL fills the strip across the line, but for corners snapped to its grid.
    DemoRun run("rasterizer", 960, 440);
    run.preset("thick").picture();
    EXPECT_GT(run.readout("differs"), 20);
    EXPECT_NEAR(run.readout("as-thick"), 5 * std::sqrt(0.5), 0.4);
    // (Another driver has another grid: at most each fourth pixel of the outline, which is twice the line, 12 across and 12 up.)
    run.set("thicken", "across").picture();
    EXPECT_LE(run.readout("differs"), onLlvmpipe() ? 3 : 0.25 * 2 * std::hypot(12, 12));
}

TEST(RasterizerFull, circle_nearest) {
    for (int radius = 0; radius <= 300; ++radius) {
        const auto pixels = circlePixels(CircleMethod::midpoint, 5, -3, radius);
        auto places = placesOf(pixels);
        std::sort(places.begin(), places.end());
        ASSERT_EQ(std::unique(places.begin(), places.end()), places.end()) << radius << ": a pixel twice";
        for (const auto& [px, py] : places) {
            const int x = std::min(std::abs(px - 5), std::abs(py + 3)),
                      y = std::max(std::abs(px - 5), std::abs(py + 3));
            // |y - sqrt(r^2 - x^2)| < 1/2, squared: no root, no rounding. Nothing lies half-way: its square would be a quarter off.
            const int below = y > 0 ? (2 * y - 1) * (2 * y - 1) : 0;
            const int square = 4 * (radius * radius - x * x);
            ASSERT_TRUE(below <= square && square < (2 * y + 1) * (2 * y + 1)) << radius << ": " << x << ", " << y;
        }
        auto roots = placesOf(circlePixels(CircleMethod::mirrored, 5, -3, radius));
        std::sort(roots.begin(), roots.end());
        ASSERT_EQ(roots, places) << radius;
    }
    EXPECT_EQ(placesOf(circlePixels(CircleMethod::midpoint, 2, 3, 0)), (std::vector{std::pair(2, 3)}));
    const auto truth = circleTruth(384);
    const auto wrong = [&](CircleMethod method) {
        const auto reached = circleTest(method, 384);
        int count = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) count += std::abs(reached[i] - truth[i]) > 0.5 ? 1 : 0;
        return count;
    };
    EXPECT_EQ(wrong(CircleMethod::midpoint), 0);
    EXPECT_GT(wrong(CircleMethod::turned), 0);
    // The demo refuses what is out of reach, and draws what is only out of sight.
    EXPECT_THROW((void)circlePixels(CircleMethod::midpoint, 0, 0, -1), Error);
    EXPECT_THROW((void)circlePixels(CircleMethod::midpoint, 0, 0, (1 << 20) + 1), Error);
    EXPECT_THROW((void)circlePixels(CircleMethod::midpoint, (1 << 30) + 1, 0, 1), Error);
    EXPECT_EQ(circlePixels(CircleMethod::midpoint, 1 << 30, -(1 << 30), 1 << 20).size() % 4, 0U);
    DemoRun run("rasterizer", 480, 220);
    (void)run.preset("circle").set("middle", "-24,-18").set("radius", "24").picture();
    EXPECT_GT(run.readout("set"), 100);
}

TEST(Rasterizer, circle_gaps) {
    // Going round, each pixel has a neighbour on either side of it, over an edge or a corner: two and more.
    const auto loose = [](CircleMethod method) {
        int count = 0;
        for (const int radius : {2, 7, 40, 191}) {
            const auto places = placesOf(circlePixels(method, 0, 0, radius));
            const std::set<std::pair<int, int>> set(places.begin(), places.end());
            for (const auto& [x, y] : set) {
                int neighbours = 0;
                for (int i = -1; i <= 1; ++i) {
                    for (int j = -1; j <= 1; ++j) neighbours += (i != 0 || j != 0) && set.contains({x + i, y + j});
                }
                count += neighbours < 2 ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_GT(loose(CircleMethod::columns), 20);
    for (const CircleMethod method : {CircleMethod::mirrored, CircleMethod::turned, CircleMethod::midpoint})
        EXPECT_EQ(loose(method), 0);
}

TEST(RasterizerFull, one_decides) {
    // The frame is round the pixel that was set last: red half a pixel inside of its upper edge
    const auto steps = linePixels(LineMethod::octants, 2, 3, 20, 11);
    DemoRun run("rasterizer", 960, 440);
    for (const int step : {1, 10, 11, 18}) {
        const Picture picture = run.set("step", step).picture();
        for (std::size_t i = 0; i < steps.size(); ++i) {
            rasterizer::Settings s;
            s.step = step;
            const FrameInfo frame(1, 960, 440);
            const vec2 corner = rasterizer::plotOf(frame, rasterizer::Grid(s)).pixel({steps[i].x + 0.5, steps[i].y});
            const Pixel at = picture.at(int(corner.x), 439 - int(corner.y));
            EXPECT_EQ(at.red > 180 && at.green < 90, int(i) == step - 1) << step << ", " << i;
        }
    }
    // The line steps up to the right of 0. The bar is the only blue, or red, that thick below the grid
    const Plot grid = rasterizer::plotOf(FrameInfo(1, 960, 440), rasterizer::Grid(rasterizer::Settings{}));
    const int row =
        439 - int(grid.box.low.y - 6 - 2.1 * 14) + 4;  // below the axis, which goes through the middle of the bar
    const double zero = grid.box.low.x + grid.box.size().x / 4;
    const auto barIsUp = [&](int step) {
        const Picture picture = run.set("step", step).picture();
        long up = 0, level = 0;
        for (int x = 10; x < 300; ++x) {
            const Pixel p = picture.at(x, row);
            up += x > zero && p.red > 180 && p.green < 90;
            level += x < zero && p.blue > 180 && p.red < 90;
        }
        EXPECT_NE(up > 3, level > 3) << step;
        return up > 3;
    };
    for (int step = 3; step < 18; ++step) {
        const bool isUp = steps[std::size_t(step)].y > steps[std::size_t(step) - 1].y;
        if (steps[std::size_t(step) - 1].error + 16 == 0) continue;  // no bar
        EXPECT_EQ(barIsUp(step), isUp) << step;
    }
}

TEST(Rasterizer, one_by_one) {
    for (const char* preset : {"bresenham", "circle", "shared-edge"}) {
        const auto demo = findDemo("rasterizer").make();
        const auto& presets = findDemo("rasterizer").presets;
        applyPreset(*demo, *std::ranges::find(presets, preset, &Preset::name));
        demo->knob("step").parse("999");  // all
        DemoRun run("rasterizer", 480, 220);
        (void)run.preset(preset).picture();
        const double all = run.readout("set");
        Knob& step = demo->knob("step");
        ASSERT_TRUE(step.step(-1));
        EXPECT_EQ(demo->number("step"), all - 1) << "one press takes one away";
        ASSERT_TRUE(step.step(-1));
        EXPECT_EQ(demo->number("step"), all - 2);
        ASSERT_TRUE(step.step(1));
        ASSERT_TRUE(step.step(1));
        EXPECT_EQ(demo->number("step"), 999) << "all again, however many they will be";
        EXPECT_FALSE(step.step(1)) << "there are no more";
        // A number beyond what there is acts like all.
        step.parse("900");
        ASSERT_TRUE(step.step(-1));
        EXPECT_EQ(demo->number("step"), all - 1);
    }
}

TEST(Rasterizer, two_insides) {
    DemoRun run("rasterizer", 480, 220);
    run.set("subject", "star");
    (void)run.set("winding", "even-odd").picture();
    const double odd = run.readout("set");
    (void)run.set("winding", "nonzero").picture();
    EXPECT_GT(run.readout("set"), odd + 20) << "the pentagon in the middle";
    // A square wound twice is outside of itself by even and odd.
    const std::vector<vec2> twice{{2, 2}, {8, 2}, {8, 8}, {2, 8}, {2, 2}, {8, 2}, {8, 8}, {2, 8}};
    EXPECT_EQ(polygonPixels(twice, 10, 10, Winding::evenOdd).size(), 0U);
    EXPECT_EQ(polygonPixels(twice, 10, 10, Winding::nonZero).size(), 36U);
    // Both are what its triangles cover, for a simple polygon.
    const std::vector<vec2> triangle{{1.25, 0.75}, {9, 3.5}, {4.5, 9.25}};
    const auto covered = coveredPixels({triangle[0], triangle[1], triangle[2]}, 10, 10, FillMethod::brute).pixels;
    for (const Winding winding : {Winding::evenOdd, Winding::nonZero})
        EXPECT_EQ(placesOf(polygonPixels(triangle, 10, 10, winding)), placesOf(covered));
    // Also where middles lie on edges, which no rounding decides
    Random random(41);
    for (int i = 0; i < 2000; ++i) {
        Corners corners;
        for (vec2& corner : corners) {
            const double x = std::floor(random.number(0, 40)) + 0.5;
            corner = {x, std::floor(random.number(0, 30)) + 0.5};
        }
        ASSERT_EQ(placesOf(polygonPixels({corners.begin(), corners.end()}, 40, 30, Winding::evenOdd)),
                  placesOf(coveredPixels(corners, 40, 30, FillMethod::brute).pixels))
            << i;
    }
}
