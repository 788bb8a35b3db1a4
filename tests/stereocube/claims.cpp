// The claims of stereocube, and a test for each; row X39 of docs/stability.md.
//
// - [left-is-red-channel] The left eye's picture is the one that changes red, on white and on black, by lines and by masks.
// - [left-is-left] The eye behind the red filter is the one on the left: near things move right in its picture.
// - [masks-lose-nothing] With masks each eye's picture is whole; with lines the nearer colour cuts gaps at crossings.
// - [toe-in-is-crooked] Toe-in moves corners up in one eye and down in the other; the less, the further the eyes meet.
// - [off-axis-is-level] Off-axis leaves no vertical parallax at all, whatever the convergence.
// - [zero-at-convergence] Off-axis, what is at the convergence distance has no parallax: the screen is there.
// - [cube-out-of-view] A setting with no part of the cube before the eyes is refused.
// - [eyes-turn-outwards] On a screen of a known width the parallax is told in millimetres, the ruler is 63.5 mm long, and what is
//   more than that is warned of. Off-axis no depth has more than the parallax at infinity.
// - [side-by-side] Each half is one eye's picture; for crossed eyes they are exchanged.
// - [four-dimensions] The unturned cube of four dimensions is the original's: 32 edges, a cube of side 0.3 in a cube of side 1.
//   Turns keep all its lengths, and a corner at the eye in the fourth dimension is refused.
// - [wide-lines] A line of 3 pixels is that of 1 pixel, drawn at five places.
// - [channels-of-one-eye] In full and half colour and in grey, red is the left eye's alone and green and blue are the right eye's;
//   least squares takes from both.
// - [as-published] The matrices of least squares are Dubois's, to the last digit that he printed.
// - [glasses-leak] Real red glass lets 19 % of the other picture through, cyan glass 6 %.
// - [eyes-disagree] The red ball of full colour is bright behind red glass and dark behind cyan. Grey has no rivalry and loses all
//   colour; least squares has less rivalry than half colour, and half colour than full colour.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <string>
#include <vector>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "stereocube/stereocube.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// Which pixels are inked, by a rule that says what ink is.
using Ink = std::vector<bool>;
Ink inkOf(const Picture& picture, const std::function<bool(Pixel)>& isInk) {
    Ink ink;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) ink.push_back(isInk(picture.at(x, y)));
    }
    return ink;
}

// The channels that are seen through the filters: the red one lets the red channel pass, the cyan one green and blue. Ink is what is
// not as bright as the paper.
Ink throughRed(const Picture& picture, int paper) {
    return inkOf(picture, [=](Pixel p) { return p.red != paper; });
}
Ink throughCyan(const Picture& picture, int paper) {
    return inkOf(picture, [=](Pixel p) { return p.green != paper || p.blue != paper; });
}
Ink anyInk(const Picture& picture, int paper) {
    return inkOf(picture, [=](Pixel p) { return p.red != paper || p.green != paper || p.blue != paper; });
}

long count(const Ink& ink) { return std::count(ink.begin(), ink.end(), true); }

// Inked in a and not in b.
long lost(const Ink& a, const Ink& b) {
    long pixels = 0;
    for (std::size_t i = 0; i < a.size(); ++i) pixels += a[i] && !b[i];
    return pixels;
}

// Mean column, first and last row of the ink in a picture of this width.
struct Extent {
    double middle = 0;
    std::size_t top = 0, bottom = 0;
};
Extent extentOf(const Ink& ink, std::size_t width) {
    Extent extent;
    double columns = 0, pixels = 0;
    for (std::size_t i = 0; i < ink.size(); ++i) {
        if (!ink[i]) continue;
        if (pixels == 0) extent.top = i / width;
        extent.bottom = i / width;
        columns += static_cast<double>(i % width);
        ++pixels;
    }
    extent.middle = columns / pixels;
    return extent;
}

struct EyePictures {
    Picture both, left, right;
};
EyePictures pictures(DemoRun& run) {
    EyePictures result{run.set("eyes", "both").picture(), run.set("eyes", "left").picture(),
                       run.set("eyes", "right").picture()};
    run.set("eyes", "both");
    return result;
}

int paperOf(const std::string& background) { return background == "white" ? 255 : 0; }

// The place of the eye of a view matrix.
vec3 placeOf(const mat4& eyeFromWorld) { return vec3(glm::inverse(eyeFromWorld) * vec4(0, 0, 0, 1)); }

// A few dozen roundings of numbers up to 600, each 1e-13 at most.
constexpr double pixelRounding = 1e-11;

}  // namespace

TEST(StereocubeFull, left_is_red_channel) {
    DemoRun run("stereocube");
    run.preset("original");
    run.set("spin-x", 20).set("spin-y", 30);
    for (const std::string background : {"white", "black"}) {
        const int paper = paperOf(background);
        for (const std::string colors : {"lines", "masks"}) {
            SCOPED_TRACE(testing::Message() << colors << " on " << background);
            const EyePictures p = pictures(run.set("background", background).set("colors", colors));
            // Alone, each eye's picture is seen whole through its own filter, and not at all through the other.
            EXPECT_GT(count(throughRed(p.left, paper)), 1000);
            EXPECT_EQ(count(throughCyan(p.left, paper)), 0);
            EXPECT_GT(count(throughCyan(p.right, paper)), 1000);
            EXPECT_EQ(count(throughRed(p.right, paper)), 0);
            // Together, each filter shows its own eye's lines and none of the other's.
            EXPECT_EQ(lost(throughRed(p.both, paper), anyInk(p.left, paper)), 0);
            EXPECT_EQ(lost(throughCyan(p.both, paper), anyInk(p.right, paper)), 0);
            EXPECT_GT(count(throughRed(p.both, paper)), 1000);
            EXPECT_GT(count(throughCyan(p.both, paper)), 1000);
        }
    }
}

TEST(StereocubeFull, left_is_left) {
    DemoRun run("stereocube");
    run.preset("original");
    run.picture();
    // The original: red is the eye at x = -0.1, cyan the one at +0.1. The eyes look along +z, so right is -x.
    const mat4 red = lookAt({-0.1, 0, -3}, {0, 0, -1}, {0, 1, 0}), cyan = lookAt({0.1, 0, -3}, {0, 0, -1}, {0, 1, 0});
    EXPECT_EQ(run.matrix("rightFromWorld"), red);
    EXPECT_EQ(run.matrix("leftFromWorld"), cyan);
    for (const std::string stereo : {"toe-in", "off-axis"}) {
        run.set("stereo", stereo).picture();
        const mat4 left = run.matrix("leftFromWorld");
        const vec3 rightwards(glm::inverse(left) * vec4(1, 0, 0, 0));
        EXPECT_GT(glm::dot(rightwards, placeOf(run.matrix("rightFromWorld")) - placeOf(left)), 0.19);
    }
    // In the pictures: the whole cube before the screen, so the left eye sees it further to the right.
    for (const std::string background : {"white", "black"}) {
        for (const std::string colors : {"lines", "masks"}) {
            run.set("background", background).set("colors", colors).set("z-dist", -2).set("convergence", 6);
            const Picture picture = run.picture();
            const int paper = paperOf(background);
            const double behindRed = extentOf(throughRed(picture, paper), 600).middle;
            const double behindCyan = extentOf(throughCyan(picture, paper), 600).middle;
            EXPECT_GT(behindRed, behindCyan + 5) << colors << " on " << background;
            EXPECT_LT(run.readout("parallax-max"), 0);
        }
    }
}

TEST(StereocubeFull, masks_lose_nothing) {
    DemoRun run("stereocube");
    run.preset("original");
    run.set("spin-x", 20).set("spin-y", 30);
    for (const std::string background : {"white", "black"}) {
        const int paper = paperOf(background);
        const EyePictures masks = pictures(run.set("background", background).set("colors", "masks"));
        EXPECT_EQ(throughRed(masks.both, paper), anyInk(masks.left, paper));
        EXPECT_EQ(throughCyan(masks.both, paper), anyInk(masks.right, paper));
        const EyePictures lines = pictures(run.set("colors", "lines"));
        const long gaps = lost(anyInk(lines.left, paper), throughRed(lines.both, paper)) +
                          lost(anyInk(lines.right, paper), throughCyan(lines.both, paper));
        EXPECT_GT(gaps, 10);
        // The gaps are where both have lines, and nowhere else.
        const Ink left = anyInk(lines.left, paper), right = anyInk(lines.right, paper);
        EXPECT_EQ(gaps, count(left) - lost(left, right));
    }
}

TEST(Stereocube, toe_in_is_crooked) {
    DemoRun run("stereocube");
    run.preset("original");
    run.set("convergence", 1).picture();
    const double nearest = run.readout("vertical-parallax");
    EXPECT_GT(nearest, 5);
    for (const double convergence : {2, 4, 8}) {
        run.set("convergence", convergence).picture();
        // As the angle between the eyes, so as 1/convergence but for the difference of angle and tangent.
        EXPECT_NEAR(run.readout("vertical-parallax") * convergence / nearest, 1, 0.01);
    }
    // The readout against the corners themselves: the front face's are the nearest, and the worst.
    run.set("convergence", 1).picture();
    double largest = 0;
    for (const vec3 corner : {vec3(0.5, 0.5, -0.5), vec3(-0.5, 0.5, -0.5)}) {
        const auto height = [&](const std::string& clip, const std::string& eye) {
            return ndcFromClip(run.matrix(clip) * run.matrix(eye) * vec4(corner, 1)).y * 300;
        };
        largest = std::max(
            largest, std::abs(height("clipFromLeft", "leftFromWorld") - height("clipFromRight", "rightFromWorld")));
    }
    EXPECT_NEAR(run.readout("vertical-parallax"), largest, pixelRounding);
    // And in the picture: the upper corners of the left eye's cube, left and right, are at different heights.
    const Ink ink = anyInk(run.set("eye-sep", 0.5).set("eyes", "left").picture(), 255);
    const auto topOfColumn = [&](std::size_t x) {
        for (std::size_t y = 0; y < 600; ++y) {
            if (ink[y * 600 + x]) return static_cast<int>(y);
        }
        return 600;
    };
    std::vector<int> tops;
    for (std::size_t x = 0; x < 600; ++x) {
        if (topOfColumn(x) < 600) tops.push_back(topOfColumn(x));
    }
    ASSERT_GT(tops.size(), 100U);
    EXPECT_GT(std::abs(tops.front() - tops.back()), 10);
}

TEST(StereocubeFull, off_axis_is_level) {
    DemoRun run("stereocube");
    run.preset("original");
    run.set("stereo", "off-axis");
    for (const double convergence : {0.25, 0.5, 1.0, 3.0, 10.0}) {
        for (const double spin : {0, 33}) {
            run.set("convergence", convergence).set("spin-x", spin).set("spin-y", 2 * spin).picture();
            EXPECT_LT(run.readout("vertical-parallax"), pixelRounding) << convergence;
        }
    }
    run.set("convergence", 2).set("spin-x", 20).set("spin-y", 30).set("eye-sep", 0.5);
    const auto rows = [&](const std::string& eye) {
        return extentOf(anyInk(run.set("eyes", eye).picture(), 255), 600);
    };
    EXPECT_EQ(rows("left").top, rows("right").top);
    EXPECT_EQ(rows("left").bottom, rows("right").bottom);
    run.set("stereo", "toe-in");
    EXPECT_NE(rows("left").top, rows("right").top);  // the twin
    // As near as the near plane, or nearer, there is no screen: refused by the range.
    EXPECT_THROW(run.set("convergence", 0.2), Error);
}

TEST(Stereocube, zero_at_convergence) {
    DemoRun run("stereocube");
    run.preset("original");
    run.set("stereo", "off-axis").set("colors", "masks").set("z-dist", -2.5);
    const Picture picture = run.picture();
    EXPECT_NEAR(run.readout("parallax-min"), 0, pixelRounding);  // the near face, 2 ahead
    const double focal = 300 / std::tan(radians(25.0));
    EXPECT_NEAR(run.readout("parallax-max"), focal * 0.2 * (1 / 2.0 - 1 / 3.0),
                pixelRounding);  // the far face, 3 ahead
    // Both eyes ink the near face's four edges at the same pixels: black, nothing left of either channel.
    const double side = focal * 1 / 2.0;
    EXPECT_GT(static_cast<double>(countPixels(picture, {0, 0, 0})), 3.9 * side);
    // Toed in, less than half of that: what is common where they cross, which is more where a driver sets the pixels beside a line.
    EXPECT_LT(static_cast<double>(countPixels(run.set("stereo", "toe-in").picture(), {0, 0, 0})), 3.9 * side / 2);
}

TEST(Stereocube, cube_out_of_view) {
    DemoRun run("stereocube");
    run.preset("original");
    for (const double z : {-0.4, 0.0, 0.3, 2.0}) {
        EXPECT_EQ(run.set("z-dist", z).refusal(),
                  "--z-dist: must leave some of the cube in view of an eye, " + numberText(z));
    }
    // On the way through a turned cube there is something to see from the middle of it.
    EXPECT_EQ(run.set("z-dist", 0).set("spin-y", 45).set("spin-x", 30).refusal(), "");
    EXPECT_GT(countColors(run.picture()), 1);
    // Each setting is in its range, and yet the eyes squint past the cube.
    run.set("spin-y", 0).set("spin-x", 0).set("z-dist", -3).set("eye-sep", 1).set("convergence", 0.25);
    EXPECT_EQ(run.refusal().rfind("--z-dist", 0), 0U);
}

TEST(Stereocube, eyes_turn_outwards) {
    DemoRun run("stereocube");
    run.set("stereo", "off-axis").set("colors", "masks");
    run.picture();
    EXPECT_FALSE(run.measured("parallax-mm")) << "of no width nothing is known";
    const double pixels = run.readout("parallax-max");
    for (const double width : {160.0, 345.0, 6000.0}) {
        run.set("screen-width", width).picture();
        EXPECT_NEAR(run.readout("parallax-mm"), pixels * width / 600, pixelRounding * width);
        // Similar triangles: at infinity it is the eyes' distance, at the scale of the screen's window
        EXPECT_NEAR(run.readout("infinity-mm"), 0.2 * width / (4 * std::tan(radians(25.0))), 1e-12 * width);
        EXPECT_LT(run.readout("parallax-mm"), run.readout("infinity-mm"));
        EXPECT_EQ(run.messages().size(), run.readout("parallax-mm") > 63.5 ? 1U : 0U) << width;
    }
    EXPECT_EQ(run.messages().front().rfind("eyes that are 63.5 mm apart", 0), 0U);
    // The lower bar, dark grey, from 10 on: 63.5 of 345 mm are 110.4 of 600 pixels
    const Picture ruled = run.set("screen-width", 345).set("z-dist", -3).picture();
    long longest = 0;
    for (int y = 540; y < 600; ++y) {
        long inRow = 0;
        for (int x = 0; x < 600; ++x) inRow += sameColor(ruled.at(x, y), {64, 64, 64});
        longest = std::max(longest, inRow);
    }
    EXPECT_NEAR(static_cast<double>(longest), 63.5 / 345 * 600, 2);
    // A point before the screen asks for no turn outwards, however wide it is
    run.set("z-dist", -2).set("convergence", 6).set("screen-width", 20000).picture();
    EXPECT_LT(run.readout("parallax-mm"), 0);
    EXPECT_EQ(run.messages().size(), 0U);
}

TEST(StereocubeFull, side_by_side) {
    const auto alone = [](const std::string& eye) {
        DemoRun run("stereocube", 600, 600);
        run.set("stereo", "off-axis").set("colors", "masks").set("plan", "off");
        return anyInk(run.set("eyes", eye).picture(), 255);
    };
    const Ink left = alone("left"), right = alone("right");
    EXPECT_GT(lost(left, right), count(left) / 4) << "the eyes see it differently: the check can fail";
    DemoRun run("stereocube", 1200, 600);
    run.set("stereo", "off-axis");
    for (const std::string eyes : {"side-by-side", "crossed"}) {
        const Picture both = run.set("eyes", eyes).picture();
        std::array<Ink, 2> halves;
        for (int y = 0; y < 600; ++y) {
            for (int x = 0; x < 1200; ++x)
                halves.at(std::size_t(x / 600)).push_back(both.at(x, y) != Pixel{255, 255, 255});
        }
        const bool isCrossed = eyes == "crossed";
        // A line may be drawn beside where it was, since the half begins at another pixel
        EXPECT_LE(lost(left, halves.at(isCrossed ? 1 : 0)), count(left) / 100) << eyes;
        EXPECT_LE(lost(right, halves.at(isCrossed ? 0 : 1)), count(right) / 100) << eyes;
        EXPECT_EQ(countColors(both), 2) << "ink and paper: no colour takes part";
    }
    // In narrow halves the whole cube has room, too
    DemoRun narrow("stereocube", 600, 600);
    const Picture halves = narrow.set("eyes", "side-by-side").picture();
    for (const int x : {0, 299, 300, 599}) {
        for (int y = 0; y < 600; ++y) ASSERT_EQ(halves.at(x, y), (Pixel{255, 255, 255})) << x << " " << y;
    }
}

TEST(Stereocube, four_dimensions) {
    using namespace stereocube;
    // Unturned it is the original's: corners at 0.5 and at 0.15, of each sign
    const MeshData still = wireHypercube({});
    ASSERT_EQ(still.positions.size(), 64U);
    std::map<double, int> sizes;
    for (const fvec3& at : still.positions) {
        EXPECT_EQ(std::abs(at.x), std::abs(at.y));
        EXPECT_EQ(std::abs(at.x), std::abs(at.z));
        ++sizes[std::round(1e6 * std::abs(at.x)) / 1e6];
    }
    EXPECT_EQ(sizes, (std::map<double, int>{{0.15, 32}, {0.5, 32}}));
    // A turn keeps lengths: its columns are orthonormal, to some roundings, and it does turn
    const Hypercube turned{.xy = 31, .xw = 25, .yw = -170, .zw = 77, .inner = 0.9};
    EXPECT_LT(glm::length(turnOf(turned)[0] - vec4(1, 0, 0, 0)), 2);
    const mat4 product = glm::transpose(turnOf(turned)) * turnOf(turned);
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) EXPECT_NEAR(product[column][row], column == row ? 1 : 0, 1e-15);
    }
    // At inner = 1 nothing is divided: edges that were parallel stay so, and there are four directions, eight edges each
    const MeshData parallel = wireHypercube({.xy = 31, .xw = 25, .yw = -170, .zw = 77, .inner = 1});
    std::vector<std::pair<vec3, int>> directions;
    for (std::size_t i = 0; i < 64; i += 2) {
        const vec3 edge = vec3(parallel.positions[i + 1]) - vec3(parallel.positions[i]);
        // Positions are floats below 1: differences are right to 2e-7
        const auto same = std::ranges::find_if(
            directions, [&](const auto& each) { return glm::length(glm::cross(each.first, edge)) < 1e-6; });
        if (same == directions.end())
            directions.emplace_back(edge, 1);
        else
            ++same->second;
    }
    ASSERT_EQ(directions.size(), 4U);
    for (const auto& [direction, edges] : directions) EXPECT_EQ(edges, 8);

    // In the picture: turns with w change it; a corner at the eye is refused
    DemoRun run("stereocube");
    run.preset("4d-cube");
    const Picture first = run.picture();
    EXPECT_NE(run.set("turn-yw", 40).picture(), first);
    run.set("turn-xw", 45).set("turn-yw", 45).set("turn-zw", 45).set("inner", 0.3);
    EXPECT_EQ(run.refusal().rfind("--inner: must be more", 0), 0U);
    EXPECT_EQ(run.set("inner", 0.6).refusal(), "");
}

TEST(Stereocube, wide_lines) {
    DemoRun run("stereocube");
    run.preset("original");
    const Ink thin = anyInk(run.set("eyes", "left").picture(), 255);
    const Ink wide = anyInk(run.set("line-width", "3").picture(), 255);
    Ink shifted(thin.size(), false);
    for (std::size_t i = 600; i + 600 < thin.size(); ++i)
        shifted[i] = thin[i] || thin[i - 1] || thin[i + 1] || thin[i - 600] || thin[i + 600];
    EXPECT_GT(count(wide), 2 * count(thin));
    // A driver may draw a line that is moved by a pixel one pixel off, as it rounds its ends anew
    EXPECT_LE(lost(wide, shifted) + lost(shifted, wide), count(wide) / 50);
}

TEST(StereocubeFull, channels_of_one_eye) {
    DemoRun run("stereocube");
    run.preset("still-life");
    const auto mixedBy = [&](const std::string& mix) { return run.set("mix", mix).picture(); };
    const Picture full = mixedBy("full"), half = mixedBy("half"), grey = mixedBy("grey"),
                  least = mixedBy("least-squares");
    long apart = 0, more = 0;
    for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 600; ++x) {
            const Pixel f = full.at(x, y), h = half.at(x, y), g = grey.at(x, y);
            ASSERT_EQ(h.red, g.red);
            ASSERT_EQ(h.green, f.green);
            ASSERT_EQ(h.blue, f.blue);
            ASSERT_EQ(g.green, g.blue);
            apart += g.red != g.green;
            more += least.at(x, y).green != f.green;
        }
    }
    EXPECT_GT(apart, 10000) << "the eyes see it from two places";
    EXPECT_GT(more, 100000);
    // From one place grey is grey, and full colour is the picture itself: red, green and blue things
    const Picture one = run.set("mix", "grey").set("eye-sep", 0).picture();
    for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 600; ++x) ASSERT_EQ(one.at(x, y).red, one.at(x, y).green);
    }
    // Through no glass, a picture for each eye has no other colours than the things
    EXPECT_EQ(run.set("eyes", "side-by-side").refusal(), "");
    EXPECT_EQ(run.picture(), run.set("mix", "full").picture()) << "beside each other nothing is mixed";
}

TEST(Stereocube, as_published) {
    using namespace stereocube;
    // Dubois (2001), as three.js has them: rows red, green, blue
    const double left[3][3] = {
        {0.456100, 0.500484, 0.176381}, {-0.0400822, -0.0378246, -0.0157589}, {-0.0152161, -0.0205971, -0.00546856}};
    const double right[3][3] = {
        {-0.0434706, -0.0879388, -0.00155529}, {0.378476, 0.73364, -0.0184503}, {-0.0721527, -0.112961, 1.2264}};
    const Mixing mixing = leastSquares();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            // Printed with six digits, the largest with five
            EXPECT_NEAR(mixing.fromLeft[column][row], left[row][column], 5.1e-7);
            EXPECT_NEAR(mixing.fromRight[column][row], right[row][column], row == 2 && column == 2 ? 5e-6 : 5.1e-7);
        }
    }
    for (const Mix mix : {Mix::full, Mix::half, Mix::grey, Mix::leastSquares}) {
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(mixed(mixingOf(mix), vec3(1), vec3(1))[channel], 1, 1e-14) << "white stays white";
        EXPECT_EQ(mixed(mixingOf(mix), vec3(0), vec3(0)), vec3(0));
    }
}

TEST(Stereocube, glasses_leak) {
    using namespace stereocube;
    // By the rule: a picture for the other eye alone, by one for this eye alone
    const Mixing full = mixingOf(Mix::full);
    const auto seen = [&](Eyes eye, double left, double right) {
        return glm::dot(brightnessThrough(eye), mixed(full, vec3(left), vec3(right)));
    };
    EXPECT_NEAR(crosstalk(Eyes::left), 100 * seen(Eyes::left, 0, 1) / seen(Eyes::left, 1, 0), 1e-12);
    EXPECT_NEAR(crosstalk(Eyes::right), 100 * seen(Eyes::right, 1, 0) / seen(Eyes::right, 0, 1), 1e-12);
    EXPECT_NEAR(crosstalk(Eyes::left), 19, 0.5);
    EXPECT_NEAR(crosstalk(Eyes::right), 6, 0.5);
    DemoRun run("stereocube");
    run.preset("still-life").picture();
    EXPECT_EQ(run.readout("crosstalk-left"), crosstalk(Eyes::left));
    EXPECT_EQ(run.readout("crosstalk-right"), crosstalk(Eyes::right));
}

TEST(StereocubeFull, eyes_disagree) {
    DemoRun run("stereocube");
    run.preset("still-life");
    // The ball's lit side, by its colour without glasses
    const Picture bare = run.picture();
    int x = 0, y = 0, most = 0;
    for (int row = 0; row < 600; ++row) {
        for (int column = 0; column < 600; ++column) {
            const Pixel p = bare.at(column, row);
            if (p.red - p.green - p.blue > most) most = p.red - p.green - p.blue, x = column, y = row;
        }
    }
    ASSERT_GT(most, 100);
    const auto brightest = [](const Pixel& p) { return std::max({p.red, p.green, p.blue}); };
    EXPECT_GT(brightest(run.set("eyes", "left").picture().at(x, y)), 190);
    EXPECT_LT(brightest(run.set("eyes", "right").picture().at(x, y)), 110);

    run.set("eyes", "both");
    const auto told = [&](const std::string& mix, const std::string& name) {
        run.set("mix", mix).picture();
        return run.readout(name);
    };
    EXPECT_EQ(told("grey", "rivalry"), 0);
    EXPECT_LT(told("least-squares", "rivalry"), told("half", "rivalry"));
    EXPECT_LT(told("half", "rivalry"), told("full", "rivalry"));
    for (const std::string mix : {"full", "half", "least-squares"})
        EXPECT_LT(told(mix, "color-loss"), told("grey", "color-loss")) << mix;
}
