// The claims of cube-persp, and a test for each.
//
// - [same-as-frustum] perspective is frustum with the bounds shown, to the last bits.
// - [shifted-window] A moved window shows straight ahead moved the other way, at every distance, and turns nothing.
// - [fovx-follows] The angle across follows from fov and aspect: tan(fovx/2) = aspect tan(fov/2).
// - [farther-is-smaller] A face is drawn in inverse proportion to its distance from the eye, at any field of view.
// - [near-opens-the-cube] Near beyond the front face opens the cube: the inside of the others is seen.
// - [near-costs-depth] The nearer near is, the coarser is depth at the cube; far hardly matters.
// - [near-below-far] Near not below far is refused with both, and so is a pyramid that shows no face.
// - [volume-beside] With the pyramid of view shown, the picture is the same in a smaller pane; the planes of near and far are where their
//   handles are, and follow them.
// - [stretch-is-said] Where the picture's shape is not the volume's, a note says how many times as wide or high shapes are; else none does.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "cube-persp/cube-persp.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "support/color_cube.h"
#include "support/demo_run.h"
#include "support/stretch.h"

using namespace mv::test;
using mv::mat4;
using mv::Picture;
using mv::Pixel;
using mv::vec3;
using mv::vec4;

namespace {

// How many pixels of the middle row have this colour.
int widthOf(const Picture& picture, Pixel color) {
    int count = 0;
    for (int x = 0; x < picture.width; ++x) {
        const Pixel p = picture.at(x, picture.height / 2);
        count += p.red == color.red && p.green == color.green && p.blue == color.blue;
    }
    return count;
}

// The depths in the buffer that the cube takes, least and most.
std::array<float, 2> cubeDepths(DemoRun& run) {
    const Picture picture = run.picture();
    stage().front().bind();
    std::vector<float> depths(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    glReadPixels(0, 0, picture.width, picture.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    std::array<float, 2> range{1, 0};
    for (const float depth : depths) {
        if (depth < 1) range = {std::min(range[0], depth), std::max(range[1], depth)};
    }
    return range;
}

TEST(CubePersp, stretch_is_said) { expectStretchIsSaid("cube-persp", "aspect", 1, 1.5); }

}  // namespace

TEST(CubePersp, shifted_window) {
    DemoRun run("cube-persp");
    run.picture();
    const mat4 symmetric = run.matrix("clipFromView");
    for (const double shift : {-1.0, -0.25, 0.5, 1.0}) {
        run.set("shift", shift).picture();
        const mat4 shifted = run.matrix("clipFromView");
        EXPECT_NEAR(run.readout("right") - run.readout("left"), 2 * 0.3 * std::tan(glm::radians(32.5)), 1e-15);
        for (const vec3& place : {vec3(0, 0, -0.3), vec3(0, 0, -2), vec3(0.4, -0.3, -1.5), vec3(-1, 0.2, -3)}) {
            const vec3 before = mv::ndcFromClip(symmetric * vec4(place, 1)),
                       now = mv::ndcFromClip(shifted * vec4(place, 1));
            // A few roundings of numbers up to 2
            EXPECT_NEAR(now.x, before.x - shift, 2e-15);
            EXPECT_NEAR(now.y, before.y, 2e-15);
            EXPECT_NEAR(now.z, before.z, 2e-15);
        }
    }
}

TEST(CubePersp, same_as_frustum) {
    DemoRun run("cube-persp", 16, 16);
    run.preset("original");
    for (const double fov : {10.0, 65.0, 120.0}) {
        for (const double aspect : {0.5, 1.0, 2.0}) {
            for (const double near : {0.01, 0.3, 1.4}) {
                run.set("fov", fov).set("aspect", aspect).set("near", near).picture();
                // Measured from the edges of the volume: what goes to the corners of the canonical near plane.
                const auto corners = mv::viewVolumeCorners(run.matrix("clipFromView"));
                EXPECT_NEAR(run.readout("left"), corners[0].x, 1e-13);  // an inverse of a matrix with entries of 100
                EXPECT_NEAR(run.readout("bottom"), corners[0].y, 1e-13);
                EXPECT_NEAR(run.readout("right"), corners[3].x, 1e-13);
                EXPECT_NEAR(run.readout("top"), corners[3].y, 1e-13);
                EXPECT_NEAR(run.readout("top"), near * std::tan(glm::radians(fov) / 2), 1e-15);  // of up to 2.4
                const mat4 byFrustum = glm::frustumRH_NO(run.readout("left"), run.readout("right"),
                                                         run.readout("bottom"), run.readout("top"), near, 3.0);
                const mat4 byPerspective = run.matrix("clipFromView");
                for (int column = 0; column < 4; ++column) {
                    for (int row = 0; row < 4; ++row) {
                        const double entry = byPerspective[column][row];
                        // Five roundings of 1.1e-16 each.
                        EXPECT_NEAR(byFrustum[column][row], entry, 6e-16 * std::abs(entry));
                    }
                }
                EXPECT_LT(run.readout("difference"), 6e-16 * 23);  // the largest entry is 1/(0.5 tan 5)
            }
        }
    }
}

TEST(CubePersp, fovx_follows) {
    DemoRun run("cube-persp", 16, 16);
    run.preset("original");
    for (const double fov : {10.0, 65.0, 120.0}) {
        for (const double aspect : {0.5, 1.0, 2.0}) {
            run.set("fov", fov).set("aspect", aspect).picture();
            const double fovx = run.readout("fovx");
            EXPECT_NEAR(std::tan(glm::radians(fovx / 2)), aspect * std::tan(glm::radians(fov / 2)), 1e-14);
            // A ray at that angle goes through the edge of the picture.
            const vec4 ray(std::sin(glm::radians(fovx / 2)), 0, -std::cos(glm::radians(fovx / 2)), 1);
            EXPECT_NEAR(mv::ndcFromClip(run.matrix("clipFromView") * ray).x, 1, 1e-14);  // some 20 roundings of 1
            if (aspect == 1.0) {
                EXPECT_NEAR(fovx, fov, 1e-13);
            } else if (fov > 60) {
                EXPECT_GT(std::abs(fovx - aspect * fov), 1);  // angles are not in the proportion of the sides
            }
        }
    }
}

TEST(CubePersp, farther_is_smaller) {
    DemoRun run("cube-persp");
    run.preset("original");
    straight(run);
    for (const double fov : {40.0, 65.0, 100.0}) {
        run.set("fov", fov);
        const double unitAtOne = 512 / (2 * std::tan(glm::radians(fov / 2)));  // pixels of a length 1 at distance 1
        const int front = widthOf(run.set("near", 0.3).picture(), red);        // the face at z = +0.5
        const int back = widthOf(run.set("near", 1.6).picture(), blue);        // at z = -0.5, once the front is cut off
        EXPECT_NEAR(front, unitAtOne / 1.5, 1);                                // whole pixels, an edge on each side
        EXPECT_NEAR(back, unitAtOne / 2.5, 1);
    }
}

TEST(CubePersp, near_opens_the_cube) {
    DemoRun run("cube-persp");
    run.preset("original");
    straight(run);
    const Picture closed = run.set("near", 1.4).picture();
    EXPECT_GT(countPixels(closed, red), 10000);
    for (const Pixel& inside : {blue, magenta, yellow}) EXPECT_EQ(countPixels(closed, inside), 0);
    const Picture open = run.set("near", 1.6).picture();
    EXPECT_EQ(countPixels(open, red), 0);
    for (const Pixel& inside : {blue, magenta, yellow}) EXPECT_GT(countPixels(open, inside), 1000);
}

TEST(CubePersp, near_costs_depth) {
    DemoRun run("cube-persp");
    run.preset("original");
    run.set("spin-x", 30).set("spin-y", 40).picture();  // turned, so that its pixels have different depths
    const double usualStep = run.readout("depth-step");
    const auto usual = cubeDepths(run);
    const auto close = cubeDepths(run.set("near", 0.01));
    // The part of the range that the cube takes, as drawn: n f/(f - n) times the same difference of 1/d in each.
    const double factor = (0.3 * 3 / (3 - 0.3)) / (0.01 * 3 / (3 - 0.01));
    // One step of 2^-24 on each end of a range of 0.005: 2e-5 of it; the pixels seen are the same.
    EXPECT_NEAR(double(usual[1] - usual[0]) / double(close[1] - close[0]), factor, factor * 1e-4);
    EXPECT_LT(close[1] - close[0], 0.01);
    // The readout: two points a step apart at the distance 2 are 2^-24 of the range apart.
    const double step = run.readout("depth-step");
    EXPECT_NEAR(step / usualStep, factor, 1e-12 * factor);
    const mat4 m = run.matrix("clipFromView");
    const auto depth = [&](double d) { return mv::ndcFromClip(m * vec4(0, 0, -d, 1)).z / 2 + 0.5; };
    // The step is 2e-5: the curvature of 1/d takes 1e-5 of it, rounding of the difference 4e-9.
    EXPECT_NEAR((depth(2 + step) - depth(2)) * 16777216, 1, 1e-4);
    // Far from 3 to 5 changes the step by a few per cent, where near changed it 33 times.
    run.set("far", 5).picture();
    EXPECT_NEAR(run.readout("depth-step") / step, 1, 0.05);
    EXPECT_GT(factor, 33);
}

TEST(CubePersp, near_below_far) {
    DemoRun run("cube-persp");
    run.preset("original");
    run.set("near", 2).set("far", 1.8);
    EXPECT_EQ(run.refusal(), "--near: must be less than --far 1.8, 2");
    EXPECT_THROW(run.picture(), mv::Error);
    EXPECT_EQ(run.set("far", 2).refusal(), "--near: must be less than --far 2, 2");
    run.set("far", 2.1).set("fov", 10);
    EXPECT_EQ(run.refusal(), "--near: must leave a face of the cube in view, between it and --far 2.1, 2");
    // The same between faces, with a pyramid wide enough to reach them.
    EXPECT_EQ(run.set("fov", 65).refusal(), "");
    EXPECT_GT(countColors(run.picture()), 3);
}

TEST(CubePersp, volume_beside) {
    DemoRun whole("cube-persp", 500, 500);
    const Picture both = whole.preset("turned").picture();
    const mv::FrameInfo frame(1, 500, 500);
    const mv::Pane pane = mv::picturePane(frame);
    DemoRun alone("cube-persp", pane.width, pane.height);
    const Picture picture = alone.preset("turned").set("volume", "off").picture();
    for (int y = 0; y < pane.height; ++y) {
        for (int x = 0; x < pane.width; ++x) ASSERT_EQ(both.at(x, y), picture.at(x, y)) << x << " " << y;
    }
    // The discs are drawn where the far plane's middle is, from outside
    DemoRun run("cube-persp", 500, 500);
    const auto discAt = [&](const mv::cube_persp::Settings& s) {
        const mv::ViewFigure figure = mv::cube_persp::figureOf(s);
        const mv::Pane of = mv::volumePane(frame);
        const vec3 ndc =
            mv::ndcFromClip(mv::outsideFromView(figure, of) * glm::inverse(figure.clipFromView) * vec4(0, 0, 1, 1));
        return run.picture().at(int((ndc.x + 1) / 2 * of.width), 499 - int((ndc.y + 1) / 2 * of.height));
    };
    const Pixel far{217, 64, 13};
    mv::cube_persp::Settings s;
    EXPECT_TRUE(sameColor(discAt(s), far));
    run.set("far", 2.2);
    EXPECT_FALSE(sameColor(discAt(s), far)) << "it has moved";
    s.far = 2.2;
    EXPECT_TRUE(sameColor(discAt(s), far));
}
