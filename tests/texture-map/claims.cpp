// The claims of texture-map, and a test for each.
//
// - [slips] A texture interpolated along the picture slips by the formula's amount, and one interpolated correctly does not.
// - [falls-with-the-square] The slip falls as 1/n^2 once a cell's w's are nearly alike, which takes the longer, the larger W.
// - [divide-at-the-end] u/w and v/w show the right point only when divided by 1/w.
// - [forward-leaves-holes] Texels drawn as points leave holes where they are larger than pixels, and meet where smaller.
// - [a-circle] The lecture's cylinder (cos u, h, sin u) is a circle, of no area.
// - [one-strip-runs-back] With the corners of a seam shared, one strip shows the whole texture backwards.
// - [half-at-the-pole] At a pole each cell of the texture is shown by a single triangle: half of it is lost.
// - [through-the-origin] A triangle's texture matrix has no inverse when its plane holds the origin; edges always work.
// - [beyond] Beyond 0..1 a texture repeats itself, or every other one is its mirror image, or its edge goes on; within, nothing changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/math/transform.h"
#include "support/demo_run.h"
#include "support/softpipe.h"
#include "texture-map/perspective_quad.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int side = 320;
const Pane all{0, 0, side, side};

DemoRun quadRun() { return DemoRun("texture-map", side, side); }

// The slip of each pixel in px, the upper row first; -1 where there is none.
std::vector<float> slips(DemoRun& run) {
    (void)run.picture();
    return stage().measure(1);
}

double largest(const std::vector<float>& values) { return double(*std::max_element(values.begin(), values.end())); }

// The middle of a pixel, from the lower left corner.
vec2 middleOf(std::size_t i) {
    const std::size_t row = i / side;
    return {double(i % side) + 0.5, side - double(row) - 0.5};
}

// Barycentric coordinates of a place in a triangle of the picture.
vec3 weightsOf(const vec2& a, const vec2& b, const vec2& c, const vec2& at) {
    return glm::inverse(mat3(vec3(a, 1), vec3(b, 1), vec3(c, 1))) * vec3(at, 1);
}

// The slip of one pixel by the definition: its cell's triangles, found in the picture in double precision. The smaller of
// its triangles' weights says how near it is to an edge.
struct Expected {
    double slip = 0, inside = -1;
};
Expected expectedAt(double ratio, int n, const vec2& at) {
    const mat3 pixels = pixelFromQuad(ratio, all);
    const vec2 uv = projected(glm::inverse(pixels), at), cell = glm::floor(uv * double(n));
    Expected best;
    for (const bool upper : {false, true}) {
        const vec2 corners[3] = {cell / double(n), (cell + (upper ? vec2(1, 1) : vec2(1, 0))) / double(n),
                                 (cell + (upper ? vec2(0, 1) : vec2(1, 1))) / double(n)};
        const vec3 weights =
            weightsOf(projected(pixels, corners[0]), projected(pixels, corners[1]), projected(pixels, corners[2]), at);
        const double inside = std::min({weights.x, weights.y, weights.z});
        if (inside <= best.inside) continue;
        const vec2 shown = weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
        best = {glm::distance(projected(pixels, shown), at), inside};
    }
    return best;
}

// Pixels of the surface that show another square of the texture, left of the words: within one, neighbouring texels differ by a few steps.
long otherSquares(const Picture& a, const Picture& b) {
    long count = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side * 5 / 8; ++x) count += std::abs(a.at(x, y).green - b.at(x, y).green) > 20;
    }
    return count;
}

}  // namespace

TEST(TextureMapFull, slips) {
    for (const double ratio : {1.0, 4.0, 10.0}) {
        for (const int n : {1, 2, 7}) {
            DemoRun run = quadRun();
            run.set("ratio", ratio).set("divisions", n).set("method", "affine");
            const auto shown = slips(run);
            long asked = 0;
            for (std::size_t i = 0; i < shown.size(); ++i) {
                if (shown[i] < 0) continue;
                const Expected expected = expectedAt(ratio, n, middleOf(i));
                // Corners are put on a grid of 1/256 px, which at the far edge is a part of the cell's height.
                if (expected.inside < 0.02) continue;
                EXPECT_NEAR(shown[i], expected.slip, 0.02 + 0.002 * expected.slip) << ratio << " " << n << " " << i;
                ++asked;
            }
            EXPECT_GT(asked, 20'000);
            // The formula's largest lies between pixels: where the slip is level, half a pixel changes it by little.
            const double formula = largestSlip(ratio, n, all).pixels;
            EXPECT_LE(largest(shown), formula + 0.02 + 0.002 * formula);
            EXPECT_GE(largest(shown), 0.95 * formula - 0.02);
            for (const char* method : {"correct", "by-hand"}) {
                // Floats have 24 bits, of 320 pixels some 2e-5; the plane's matrix magnifies it by W at most.
                EXPECT_LT(largest(slips(run.set("method", method))), 0.01) << method << ratio << n;
            }
        }
    }
}

TEST(TextureMap, falls_with_the_square) {
    const auto slope = [](double ratio, int from, int to) {
        return std::log(largestSlip(ratio, to, all).pixels / largestSlip(ratio, from, all).pixels) /
               std::log(double(to) / from);
    };
    for (const double ratio : {1.1, 1.5, 2.0}) EXPECT_NEAR(slope(ratio, 16, 64), -2, 0.1) << ratio;
    EXPECT_NEAR(slope(10, 32, 64), -1.7, 0.1);
    EXPECT_NEAR(slope(10, 512, 2048), -2, 0.1);
    // The flat start: the slip's formula, (sqrt(r) - 1) / (sqrt(r) + 1) of a length, cannot exceed the length.
    EXPECT_GT(slope(10, 1, 2), -1);
    EXPECT_GT(slope(10, 1, 2), slope(2, 1, 2));
    // And what the shaders show falls alike.
    DemoRun run = quadRun();
    const auto seen = [&](int n) { return largest(slips(run.set("ratio", 2).set("divisions", n))); };
    // The highest of the pixels is up to 5 % below the highest point: of both, over two doublings
    EXPECT_NEAR(std::log2(seen(16) / seen(4)) / 2, slope(2, 4, 16), 0.04);
}

TEST(TextureMap, divide_at_the_end) {
    DemoRun run = quadRun();
    run.set("ratio", 4);
    const auto handled = slips(run.set("method", "by-hand")), bare = slips(run.set("method", "undivided"));
    EXPECT_LT(largest(handled), 0.01);
    // Along the far edge u and v are a quarter of what they should be: v = 1/4 belongs at s = W v / (1 + (W - 1) v) = 4/7
    // of the height, which is 0.8 of the picture.
    EXPECT_GT(largest(bare), 3.0 / 7 * 0.8 * side * 0.95);
    // There is nothing to divide by where all w are 1.
    EXPECT_LT(largest(slips(run.set("ratio", 1))), 0.01);
}

TEST(TextureMapFull, forward_leaves_holes) {
    for (const int texels : {64, 512}) {
        DemoRun run = quadRun();
        run.set("method", "forward").set("texels", texels).set("ratio", 3);
        const auto shown = slips(run);
        const mat3 pixels = pixelFromQuad(3, all);
        // Pixels that a texel's middle falls into, and those that it may. Points are placed on a grid of 1/256 px, and on another
        // driver of the 1/16 px that OpenGL asks for at least (GL_SUBPIXEL_BITS).
        const double grid = placesPointsCoarsely() ? 1.0 / 8 : onLlvmpipe() ? 1.0 / 64 : 1.0 / 16;
        std::vector<int> sure(shown.size(), 0), perhaps(shown.size(), 0);
        for (int j = 0; j < texels; ++j) {
            for (int i = 0; i < texels; ++i) {
                const vec2 at = projected(pixels, {(i + 0.5) / texels, (j + 0.5) / texels});
                for (const double dx : {-grid, grid}) {
                    for (const double dy : {-grid, grid}) {
                        const vec2 pixel = glm::floor(at + vec2(dx, dy));
                        ++perhaps[pixelIndex(static_cast<int>(pixel.x), side - 1 - static_cast<int>(pixel.y), side)];
                    }
                }
                const vec2 pixel = glm::floor(at), within = at - pixel;
                if (std::min({within.x, within.y, 1 - within.x, 1 - within.y}) > grid)
                    ++sure[pixelIndex(static_cast<int>(pixel.x), side - 1 - static_cast<int>(pixel.y), side)];
            }
        }
        long holes = 0, holesNear = 0, holesFar = 0, asked = 0;
        const mat3 quad = glm::inverse(pixels);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const vec2 uv = projected(quad, middleOf(i));
            if (std::min({uv.x, uv.y, 1 - uv.x, 1 - uv.y}) < 0.02) continue;
            ++asked;
            if (sure[i]) {
                EXPECT_GE(shown[i], 0) << texels << " " << i;
            }
            if (!perhaps[i]) {
                EXPECT_LT(shown[i], 0) << texels << " " << i;
            }
            const bool isHole = shown[i] < 0;
            holes += isHole;
            holesNear += isHole && uv.y < 0.1;
            holesFar += isHole && uv.y > 0.8;
            // A texel falls within half a pixel's diagonal of where it belongs, and the grid's.
            if (!isHole) {
                EXPECT_LE(shown[i], std::sqrt(0.5) + std::sqrt(2) * grid);
            }
        }
        if (texels == 64) {
            EXPECT_GT(holes, asked / 2);
        }
        if (texels == 64) {
            EXPECT_GT(holesNear, 0);
        }
        if (texels == 512) {  // texels are smaller than pixels in both directions there
            EXPECT_EQ(holesFar, 0);
        }
    }
}

TEST(TextureMap, a_circle) {
    DemoRun run = quadRun();
    run.set("shape", "cylinder").set("divisions", 16);
    (void)run.picture();
    // 64 flat faces of 2 sin(pi / 64) by 2
    EXPECT_NEAR(run.readout("area"), 64 * 4 * std::sin(pi / 64), 1e-5);
    (void)run.set("formula", "lecture").picture();
    EXPECT_NEAR(run.readout("area"), 0, 1e-5);
}

TEST(TextureMap, one_strip_runs_back) {
    DemoRun run = quadRun();
    for (const int n : {1, 4, 9}) {
        run.set("divisions", n).set("shape", "cylinder").set("seam", "doubled");
        (void)run.picture();
        EXPECT_EQ(run.readout("backward"), 0);
        EXPECT_NEAR(run.readout("lost"), 0, 1e-4);
        (void)run.set("seam", "shared").picture();
        EXPECT_EQ(run.readout("backward"), 2 * n);         // of n cells, one strip of 4n
        EXPECT_NEAR(run.readout("lost"), 25.0 / n, 1e-4);  // its own part of the texture
        (void)run.set("shape", "sphere").picture();
        EXPECT_EQ(run.readout("backward"), 4 * n - 2);  // of 2n cells, two of which are single triangles
    }
    // The strip beside the seam alone changes: on the other side of the sphere, below the pole, nothing does.
    run.set("divisions", 4).set("turn", 100);
    const Picture shared = run.picture(), doubled = run.set("seam", "doubled").picture();
    for (int y = side / 3; y < side; ++y) {
        for (int x = 0; x < side; ++x) ASSERT_EQ(shared.at(x, y), doubled.at(x, y)) << x << " " << y;
    }
    run.set("turn", -60);
    const Picture whole = run.picture();
    EXPECT_GT(differentPixels(whole, run.set("seam", "shared").picture()), 500);
}

TEST(TextureMap, half_at_the_pole) {
    DemoRun run = quadRun();
    run.set("shape", "sphere");
    for (const int n : {2, 4, 16}) {
        (void)run.set("divisions", n).picture();
        EXPECT_NEAR(run.readout("lost"), 100.0 / (2 * n), 1e-4) << n;  // half of the first and of the last of 2n rows
    }
}

TEST(TextureMap, through_the_origin) {
    DemoRun run = quadRun();
    run.set("shape", "triangle").set("map", "edges").set("distance", 0);
    EXPECT_EQ(run.refusal(), "");
    (void)run.picture();
    EXPECT_LT(run.readout("off"), 1e-6);  // some roundings of floats
    EXPECT_NE(run.set("map", "matrix").refusal(), "");
    // P's determinant is three times the volume over the texture's area: in proportion to the distance.
    (void)run.set("distance", 0.5).picture();
    const double half = run.readout("determinant");
    (void)run.set("distance", 0.25).picture();
    EXPECT_NEAR(run.readout("determinant"), half / 2, 1e-9 * std::abs(half));
    // Its inverse grows as 1 / distance, and so do the roundings of what cancels.
    (void)run.set("distance", 1e-6).picture();
    EXPECT_GT(run.readout("off"), 1e-3);
    const Picture broken = run.picture(), sound = run.set("map", "edges").picture();
    EXPECT_GT(otherSquares(broken, sound), 1000);
    // By edges it is the same picture near and far, but for pixels at the very edges of squares.
    const Picture far = run.set("distance", 0.5).picture();
    EXPECT_LT(otherSquares(far, sound), 50);
}

TEST(TextureMap, beyond) {
    // Seen straight on, in panes of 3 x 3 textures: u and v from a pixel, without rounding that matters.
    DemoRun run("texture-map", 480, 480);
    run.set("method", "correct").set("ratio", 1).set("reach", 3).set("texels", 16);
    const auto pictureOf = [&](const char* wrap) { return run.set("wrap", wrap).picture(); };
    const Picture clamped = pictureOf("clamp"), repeated = pictureOf("repeat"), mirrored = pictureOf("mirror");
    const mat3 quad = glm::inverse(pixelFromQuad(1, {0, 0, 300, 480})), pixels = glm::inverse(quad);
    const auto at = [&](const Picture& picture, const vec2& uv) {
        const vec2 place = projected(pixels, 0.5 + (uv - 0.5) / 3.0);
        return picture.at(static_cast<int>(place.x), 479 - static_cast<int>(place.y));
    };
    // Middles of texels, clear of the lines that are drawn over the picture.
    for (const double u : {1.5 / 16, 4.5 / 16, 9.5 / 16, 13.5 / 16}) {
        for (const double v : {2.5 / 16, 6.5 / 16, 12.5 / 16}) {
            const Pixel inside = at(clamped, {u, v});
            EXPECT_EQ(at(repeated, {u, v}), inside);
            EXPECT_EQ(at(mirrored, {u, v}), inside);
            EXPECT_EQ(at(repeated, {u - 1, v}), inside);
            EXPECT_EQ(at(repeated, {u + 1, v + 1}), inside);
            EXPECT_EQ(at(mirrored, {-u, v}), inside);
            EXPECT_EQ(at(mirrored, {2 - u, 2 - v}), inside);
            EXPECT_EQ(at(clamped, {-u, v}), at(clamped, {0.5 / 16, v}));
            EXPECT_EQ(at(clamped, {1 + u, 1 + v}), at(clamped, {15.5 / 16, 15.5 / 16}));
        }
    }
    EXPECT_GT(differentPixels(repeated, mirrored), 1000);
    EXPECT_GT(differentPixels(repeated, clamped), 1000);
    // Within 0..1 there is no difference.
    run.set("reach", 1);
    EXPECT_EQ(differentPixels(pictureOf("repeat"), pictureOf("clamp")), 0);
}
