#include "clipping/polygon_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "mv/error.h"
#include "mv/math/clip.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

namespace bg = boost::geometry;
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<double>, false, false>;  // counter-clockwise, open

double area(const std::vector<vec2>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}

double commonArea(const GridPolygon& a, const GridPolygon& b) {
    double sum = 0;
    for (const auto& polygon : overlap(a, b).polygons) sum += area(polygon);
    return sum;
}

// The answer of Boost.Geometry, which computes in double.
double boostArea(const GridPolygon& a, const GridPolygon& b) {
    const auto made = [](const GridPolygon& from) {
        BoostPolygon polygon;
        for (const GridPoint& p : from)
            bg::append(polygon.outer(), bg::model::d2::point_xy<double>(double(p.x), double(p.y)));
        bg::correct(polygon);
        return polygon;
    };
    std::vector<BoostPolygon> common;
    bg::intersection(made(a), made(b), common);
    double sum = 0;
    for (const BoostPolygon& polygon : common) sum += bg::area(polygon);
    return sum;
}

// Simple, with so many corners in a square; on a small grid corners lie on edges, and edges on each other, all the time.
GridPolygon randomPolygon(Random& random, int corners, int size) {
    for (;;) {
        GridPolygon polygon;
        for (int i = 0; i < corners; ++i) {
            const auto x = std::lround(random.number(-size - 0.5, size + 0.5));
            polygon.push_back({x, std::lround(random.number(-size - 0.5, size + 0.5))});
        }
        if (isSimple(polygon)) return polygon;
    }
}

std::string textOf(const GridPolygon& polygon) {
    std::string text;
    for (const GridPoint& p : polygon) text += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")";
    return text;
}

const GridPolygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const GridPolygon comb{{1, -2}, {7, -2}, {7, 6}, {5, 6}, {5, -1}, {3, -1}, {3, 6}, {1, 6}};

}  // namespace

TEST(PolygonOverlap, OfASquareAndItsLikes) {
    const auto moved = [](std::int64_t x, std::int64_t y) {
        GridPolygon polygon = square;
        for (GridPoint& p : polygon) p = {p.x + x, p.y + y};
        return polygon;
    };
    EXPECT_EQ(commonArea(square, square), 16) << "the same";
    EXPECT_EQ(overlap(square, square).polygons, (std::vector<std::vector<vec2>>{{{4, 0}, {4, 4}, {0, 4}, {0, 0}}}));
    EXPECT_EQ(commonArea(square, moved(2, 2)), 4);
    EXPECT_EQ(commonArea(square, moved(2, 0)), 8) << "along two edges";
    EXPECT_TRUE(overlap(square, moved(4, 0)).polygons.empty()) << "a common edge is no area";
    EXPECT_TRUE(overlap(square, moved(4, 1)).polygons.empty());
    EXPECT_TRUE(overlap(square, moved(4, 4)).polygons.empty()) << "a common corner is no area";
    EXPECT_TRUE(overlap(square, moved(9, 9)).polygons.empty());
    EXPECT_EQ(commonArea(square, {{1, 1}, {2, 1}, {1, 2}}), 0.5) << "within";
    EXPECT_EQ(commonArea({{1, 1}, {2, 1}, {1, 2}}, square), 0.5);
    EXPECT_EQ(commonArea(square, {{2, 0}, {4, 2}, {2, 4}, {0, 2}}), 8) << "corners on edges";
    EXPECT_EQ(commonArea(square, {{1, 2}, {1, 1}, {2, 1}}), 0.5) << "whichever way round";
}

// Where Sutherland and Hodgman's method leaves one polygon with edges that overlap.
TEST(PolygonOverlap, OfAConcaveOneIsSeveral) {
    const auto common = overlap(comb, {{0, 1}, {8, 1}, {8, 5}, {0, 5}}).polygons;
    ASSERT_EQ(common.size(), 2U);
    EXPECT_EQ(area(common[0]) + area(common[1]), 16);
    for (const auto& polygon : common) EXPECT_EQ(polygon.size(), 4U);
    // Two that touch at a corner stay two.
    EXPECT_EQ(overlap({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}}, {{2, 0}, {4, 0}, {4, 4}, {2, 4}}).polygons.size(), 2U);
}

TEST(PolygonOverlap, EqualsBoostsWhereCornersAndEdgesMeet) {
    Random random(2019);
    int empty = 0, several = 0, along = 0;
    for (int i = 0; i < 1000; ++i) {
        const int size = i % 3 == 0 ? 2 : i % 3 == 1 ? 4 : 9;
        const GridPolygon a = randomPolygon(random, 3 + i % 5, size), b = randomPolygon(random, 3 + i / 5 % 5, size);
        const Overlap common = overlap(a, b);
        double ours = 0;
        for (const auto& polygon : common.polygons) {
            EXPECT_GT(area(polygon), 0) << textOf(a) << " " << textOf(b);
            ours += area(polygon);
        }
        // Boost's corners are rounded: areas up to 400 by some units in the last place
        ASSERT_NEAR(ours, boostArea(a, b), 1e-11) << textOf(a) << " " << textOf(b);
        ASSERT_EQ(ours == 0, commonArea(b, a) == 0);
        ASSERT_NEAR(ours, commonArea(b, a), 1e-11) << textOf(a) << " " << textOf(b);
        empty += common.polygons.empty() ? 1 : 0;
        several += common.polygons.size() > 1 ? 1 : 0;
        along += std::any_of(common.parts.begin(), common.parts.end(),
                             [](const EdgePart& part) { return part.lies >= EdgePart::Lies::alongSame; })
                     ? 1
                     : 0;
    }
    // There were enough of each kind
    EXPECT_GT(empty, 30);
    EXPECT_GT(several, 30);
    EXPECT_GT(along, 100);
}

TEST(PolygonOverlap, RefusesWhatIsNoPolygon) {
    const GridPolygon bow{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, spike{{0, 0}, {4, 0}, {2, 0}, {2, 2}},
        flat{{0, 0}, {2, 2}, {4, 4}}, touching{{0, 0}, {4, 0}, {4, 4}, {2, 0}}, far{{0, 0}, {70000, 0}, {0, 1}};
    for (const GridPolygon& polygon : {bow, spike, flat, touching, far, GridPolygon{}}) {
        EXPECT_FALSE(isSimple(polygon)) << textOf(polygon);
        EXPECT_THROW(overlap(polygon, square), Error) << textOf(polygon);
        EXPECT_THROW(overlap(square, polygon), Error) << textOf(polygon);
    }
    // As large as may be, with all bits in use; both are convex, so that Sutherland and Hodgman's method is right for them
    const std::int64_t most = 65536;
    const GridPolygon large{{-most, -most}, {most, 1 - most}, {most - 1, most}};
    std::vector<vec4> cut{{most, most, 0, 1}, {-most, most - 1, 0, 1}, {1 - most, -most, 0, 1}}, halfPlanes;
    for (std::size_t i = 0; i < 3; ++i) {
        const vec2 p(large[i].x, large[i].y), along = vec2(large[(i + 1) % 3].x, large[(i + 1) % 3].y) - p;
        halfPlanes.emplace_back(-along.y, along.x, 0, along.y * p.x - along.x * p.y);
    }
    std::vector<vec2> corners;
    for (const vec4& p : clipPolygon(cut, halfPlanes)) corners.emplace_back(p);
    EXPECT_NEAR(commonArea(large, {{most, most}, {-most, most - 1}, {1 - most, -most}}), area(corners),
                4 * 0x1p-53 * 6 * double(most * most))
        << "the products of six corners' coordinates, rounded";
}
