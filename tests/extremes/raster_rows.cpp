// X23, X24, X59: edges through the middles of pixels, edge functions far from the origin, and a large circle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "rasterizer/circle.h"
#include "shared/raster_triangle.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 240, height = 180;

// Pixels set twice or not at all where convex quadrilaterals on the grid of half pixels are split by a diagonal.
double wrongBetween(EdgeRule rule) {
    Random random(230);
    double wrong = 0;
    for (int i = 0; i < 150; ++i) {
        const auto half = [&](double low, double high) { return std::round(2 * random.number(low, high)) / 2; };
        const vec2 a(half(0, 100), half(0, 80)), b(half(140, 240), half(0, 80)), c(half(140, 240), half(100, 180)),
            d(half(0, 100), half(100, 180));
        const auto turn = [](const vec2& p, const vec2& q, const vec2& r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        if (std::min({turn(a, b, c), turn(b, c, d), turn(c, d, a), turn(d, a, b)}) <= 0) continue;  // not convex
        std::vector<int> times(static_cast<std::size_t>(width) * height), whole(times.size());
        const auto add = [&](const std::array<vec2, 3>& corners, EdgeRule with, std::vector<int>& to) {
            for (const PixelStep& pixel : coveredPixels(corners, width, height, FillMethod::box, with).pixels)
                ++to[static_cast<std::size_t>(pixel.y) * width + static_cast<std::size_t>(pixel.x)];
        };
        add({a, b, c}, rule, times);
        add({a, c, d}, rule, times);
        // Split by the other diagonal, whose pixels are others, the quadrilateral is the same.
        add({a, b, d}, EdgeRule::bottomLeft, whole);
        add({b, c, d}, EdgeRule::bottomLeft, whole);
        for (std::size_t k = 0; k < times.size(); ++k) {
            if (times[k] > 1 || (whole[k] == 1 && times[k] == 0)) ++wrong;
        }
    }
    return wrong;
}

[[maybe_unused]] const bool x23 = addRow([] {
    return Row{.id = "X23",
               .input = "some hundred convex quadrilaterals on the grid of half pixels, split by a diagonal",
               .measured = "pixels that both triangles set, or neither",
               .naive = "every edge keeps the pixels on it",
               .naiveError = wrongBetween(EdgeRule::inside),
               .ours = "coveredPixels: left and bottom edges keep them",
               .ourError = wrongBetween(EdgeRule::bottomLeft),
               .tolerance = 0,
               .reason = "an edge is a left or bottom one of just one of the two"};
});

// Signs of edge functions at the middles of pixels around a triangle that is so far away.
[[maybe_unused]] const bool x24 = addRow([] {
    Random random(24);
    double naive = 0, ours = 0, asked = 0;
    for (const double offset : {1e4, 1e5, 1e6}) {
        for (int i = 0; i < 300; ++i) {
            const auto corner = [&] {
                const double x = std::round(random.number(0, 64) * subPixels) / subPixels;
                return vec2(offset + x, offset + std::round(random.number(0, 64) * subPixels) / subPixels);
            };
            const std::array<vec2, 3> corners{corner(), corner(), corner()};
            for (const EdgeFunction& edge : edgeFunctions(corners, EdgeRule::bottomLeft)) {
                for (int k = 0; k < 16; ++k) {
                    const auto x = static_cast<std::int64_t>(offset + 4 * k) * subPixels + subPixels / 2;
                    const auto y = static_cast<std::int64_t>(offset + 61 - 3 * k) * subPixels + subPixels / 2;
                    const volatile float ax = static_cast<float>(edge.a) * static_cast<float>(x);
                    const volatile float by = static_cast<float>(edge.b) * static_cast<float>(y);
                    const volatile float inFloats = ax + by + static_cast<float>(edge.c);
                    const long double exact =
                        static_cast<long double>(edge.a) * x + static_cast<long double>(edge.b) * y + edge.c;
                    const auto sign = [](auto value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
                    naive += sign(float(inFloats)) != sign(exact) ? 1 : 0;
                    ours += sign(edge.at(x, y)) != sign(exact) ? 1 : 0;
                    ++asked;
                }
            }
        }
    }
    return Row{.id = "X24",
               .input = "triangles of 64 pixels, 1e4 to 1e6 pixels from the origin",
               .measured = "wrong signs of edge functions, %",
               .naive = "A x + B y + C in floats",
               .naiveError = 100 * naive / asked,
               .ours = "whole numbers of 64 bits, within a guard band of 2^22 pixels",
               .ourError = 100 * ours / asked,
               .tolerance = 0,
               .reason = "no product leaves 64 bits there"};
});

// Heights of a large circle's pixels in an eighth of it, against whole numbers of 64 bits.
double wrongOfCircle(CircleMethod method, int radius) {
    double wrong = 0, asked = 0;
    for (const PixelStep& pixel : circlePixels(method, 0, 0, radius)) {
        const std::int64_t x = pixel.x, y = pixel.y, r = radius;
        if (x < 0 || y < x) continue;
        const std::int64_t square = 4 * (r * r - x * x);
        wrong += (2 * y - 1) * (2 * y - 1) <= square && square < (2 * y + 1) * (2 * y + 1) ? 0 : 1;
        ++asked;
    }
    return 100 * wrong / asked;
}

[[maybe_unused]] const bool x59 = addRow([] {
    return Row{.id = "X59",
               .input = "a circle of radius 100000 pixels",
               .measured = "pixels of an eighth that are not the nearest, %",
               .naive = "the square root of r^2 - x^2 in floats, rounded",
               .naiveError = wrongOfCircle(CircleMethod::mirrored, 100000),
               .ours = "circlePixels, midpoint: whole numbers",
               .ourError = wrongOfCircle(CircleMethod::midpoint, 100000),
               .tolerance = 0,
               .reason = "no product leaves 32 bits up to a radius of 2^20"};
});

}  // namespace
