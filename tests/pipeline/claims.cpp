// The claims of pipeline, and a test for each.
//
// - [same-as-gpu] The products shown are the GPU's: transform feedback gives the same, bit for bit on llvmpipe.
// - [within-the-bound] A GPU's sum in any order is within 4 2^-24 sum |m v|, though many of the last bits differ.
// - [marked-where-computed] GL marks the vertex at the pixel that the numbers say.
// - [w-is-the-distance] w is how far the vertex is in front of the eye; behind the eye it is negative.
// - [behind-is-mirrored] GL draws nothing behind the eye; the division alone would show it, mirrored through the middle.
// - [depth-both-ranges] Device depth is from -1 at near to 1 at far, the depth that is stored from 0 to 1.
// - [rows-for-columns] A slide's matrix has the position in its last row: it moves row vectors, and distorts columns.
// - [slide-of-projection] A slide's projection has w < 0 for all that the camera sees, and nothing is left to draw.
// - [one-product-far-out] One product, multiplied in double and rounded once, keeps the picture far from the origin.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "mv/demo/demo.h"
#include "mv/study/study.h"
#include "pipeline/gpu_product.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int side = 560;  // of the view, pixels

constexpr double half = 0.6;
vec4 corner(int i) { return vec4(half * (2.0 * vec3(i & 1, i >> 1 & 1, i >> 2 & 1) - 1.0), 1); }

vec4 clipOf(DemoRun& run, int vertex) {
    return run.matrix("clipFromCamera") * run.matrix("cameraFromWorld") * run.matrix("worldFromModel") * corner(vertex);
}

// The middle of the black pixels of the view, from its lower left corner: of the mark, for words are not black.
std::optional<vec2> markedAt(const Picture& picture) {
    vec2 sum(0);
    long count = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Pixel p = picture.at(x, y);
            if (p.red + p.green + p.blue > 0) continue;
            sum += vec2(x + 0.5, side - y - 0.5);
            ++count;
        }
    }
    if (count == 0) return {};
    return sum / double(count);
}

// Pixels of the view in one of the cube's six colours.
long cubePixels(const Picture& picture) {
    long count = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Pixel p = picture.at(x, y);
            const auto pure = [](int level) { return level == 0 || level == 255; };
            const int sum = p.red + p.green + p.blue;
            count += pure(p.red) && pure(p.green) && pure(p.blue) && sum > 0 && sum < 3 * 255 ? 1 : 0;
        }
    }
    return count;
}

bool isLlvmpipe() { return stage().driver().renderer.find("llvmpipe") != std::string::npos; }

}  // namespace

TEST(PipelineFull, same_as_gpu) {
    DemoRun run("pipeline");
    // Elsewhere within four units of 2^-24 sum |m v|, where a driver may use fused multiply-adds or another order.
    const double most = isLlvmpipe() ? 0 : 4;
    struct Share {
        double fused = 0, once = 0, numbers = 0;
    };
    Share three, single;
    for (const char* products : {"shader", "single", "once"}) {
        const bool byThree = std::string(products) == "shader";
        Share& share = byThree ? three : single;
        run.set("products", products);
        for (const double offset : {0.0, 12.5, 1e4}) {
            run.set("offset", offset);
            for (int vertex = 0; vertex < 8; ++vertex) {
                run.set("vertex", vertex).set("spin-x", 41.0 * vertex - 100).set("spin-y", 17.0 * vertex);
                run.set("distance", 0.9 * vertex - 2.5);
                run.picture();
                EXPECT_LE(run.readout("gpu-off"), most) << products << ", offset " << offset << ", vertex " << vertex;
                share.fused += run.readout("fused-differ");
                share.once += run.readout("once-differ");
                share.numbers += byThree ? 12 : 4;
            }
        }
    }
    // So it means something that the bits are the same: another way of adding up changes many of them. Measured 7 and 26 %
    // with three matrices, many of whose numbers are 0 and 1, and 15 and 27 % with one.
    EXPECT_GT(three.fused / three.numbers, 0.03);
    EXPECT_GT(three.once / three.numbers, 0.1);
    EXPECT_GT(single.fused / single.numbers, 0.08);
    EXPECT_GT(single.once / single.numbers, 0.15);
}

TEST(Pipeline, within_the_bound) {
    DemoRun run("pipeline");
    double largest = 0;
    for (int vertex = 0; vertex < 8; ++vertex) {
        run.set("vertex", vertex)
            .set("spin-x", 40.0 * vertex)
            .set("spin-y", 25.0 * vertex)
            .set("offset", 1000.0 * vertex);
        run.picture();
        fvec4 value(corner(vertex));
        for (const char* name : {"worldFromModel", "cameraFromWorld", "clipFromCamera"}) {
            const fmat4 m(run.matrix(name));
            const vec4 right = mat4(m) * vec4(value);  // products are exact in double, the sum is to 2^-52
            const vec4 unit = productUnit(m, value);
            // In each order of the four terms, fused or not.
            std::array<int, 4> order{0, 1, 2, 3};
            do {
                fmat4 shuffled;
                fvec4 with;
                for (int k = 0; k < 4; ++k) {
                    shuffled[k] = m[order[std::size_t(k)]];
                    with[k] = value[order[std::size_t(k)]];
                }
                const fvec4 plain = gpuProduct(shuffled, with), fused = fusedProduct(shuffled, with);
                for (int row = 0; row < 4; ++row) {
                    EXPECT_LE(std::abs(plain[row] - right[row]), 4 * unit[row]);
                    EXPECT_LE(std::abs(fused[row] - right[row]), 4 * unit[row]);
                    if (unit[row] > 0) largest = std::max(largest, std::abs(plain[row] - right[row]) / unit[row]);
                }
            } while (std::next_permutation(order.begin(), order.end()));
            value = gpuProduct(m, value);
        }
    }
    EXPECT_GT(largest, 0.5) << "the bound is not idle";
}

TEST(Pipeline, marked_where_computed) {
    DemoRun run("pipeline");
    for (int vertex = 0; vertex < 8; ++vertex) {
        for (const char* products : {"shader", "once"}) {
            run.set("vertex", vertex).set("products", products).set("spin-x", 30.0 * vertex).set("spin-y", 50 - vertex);
            const auto mark = markedAt(run.picture());
            ASSERT_TRUE(mark) << vertex;
            // Nine pixels whose middles are within 4.5 of the place: their mean is within half a pixel of it.
            EXPECT_NEAR(mark->x, run.readout("pixel-x"), 0.51) << vertex;
            EXPECT_NEAR(mark->y, run.readout("pixel-y"), 0.51) << vertex;
        }
    }
}

TEST(Pipeline, w_is_the_distance) {
    DemoRun run("pipeline");
    for (const int vertex : {0, 3, 7}) {
        run.set("vertex", vertex).set("distance", 3).picture();
        const double w = run.readout("w");
        // In front of the eye, along its gaze, measured in the world
        const mat4 camera = run.matrix("cameraFromWorld");
        const vec3 gaze(-camera[0][2], -camera[1][2], -camera[2][2]);
        const vec3 world(run.matrix("worldFromModel") * corner(vertex)), eye = -3.0 * gaze;
        EXPECT_NEAR(w, glm::dot(world - eye, gaze), 1e-6);  // w is a float near 3, of three products
        for (const double distance : {5.0, 1.0, -2.0}) {
            run.set("distance", distance).picture();
            EXPECT_NEAR(run.readout("w"), w - 3 + distance, 2e-6) << vertex;
        }
        // The coordinate w changes its sign where the eye passes the vertex.
        run.set("distance", 3 - w + 0.001).picture();
        EXPECT_GT(run.readout("w"), 0);
        run.set("distance", 3 - w - 0.001).picture();
        EXPECT_LT(run.readout("w"), 0);
        EXPECT_FALSE(run.messages().empty());
    }
}

TEST(Pipeline, behind_is_mirrored) {
    DemoRun run("pipeline");
    run.set("distance", 0.2);
    const Picture picture = run.picture();
    EXPECT_FALSE(markedAt(picture));
    EXPECT_FALSE(run.measured("pixel-x"));
    // Divided all the same it falls where the point opposite, as far in front of the eye, does; and that is the vertex
    // turned over in x and y.
    const vec4 clip = clipOf(run, 7);
    ASSERT_LT(clip.w, 0);
    const vec4 camera = run.matrix("cameraFromWorld") * run.matrix("worldFromModel") * corner(7);
    const vec4 opposite = run.matrix("clipFromCamera") * vec4(-camera.x, -camera.y, -camera.z, 1);
    const vec2 divided = vec2(clip) / clip.w;
    EXPECT_NEAR(divided.x, opposite.x / opposite.w, 1e-12);
    EXPECT_NEAR(divided.y, opposite.y / opposite.w, 1e-12);
    const vec4 before = run.matrix("clipFromCamera") * vec4(camera.x, camera.y, -camera.z, 1);
    EXPECT_NEAR(divided.x, -before.x / before.w, 1e-12);
    EXPECT_NEAR(divided.y, -before.y / before.w, 1e-12);
    // The picture has a red cross there, which is all that shows it.
    const vec2 place = (divided + 1.0) / 2.0 * double(side);
    int reddish = 0;
    for (int y = -6; y <= 6; ++y) {
        for (int x = -6; x <= 6; ++x) {
            const Pixel p = picture.at(int(place.x) + x, side - int(place.y) + y);
            reddish += p.red > 190 && p.red < 225 && p.green < 110 && std::abs(p.green - p.blue) < 8 ? 1 : 0;
        }
    }
    EXPECT_GT(reddish, 5);
}

TEST(Pipeline, depth_both_ranges) {
    DemoRun run("pipeline");
    int crossed = 0;
    for (const double near : {0.1, 0.5, 2.0}) {
        for (const double far : {5.0, 100.0}) {
            run.set("near", near).set("far", far).set("distance", 4).picture();
            const mat4 p = run.matrix("clipFromCamera");
            const vec4 first = p * vec4(0, 0, -near, 1), last = p * vec4(0, 0, -far, 1);
            EXPECT_NEAR(first.z / first.w, -1, 1e-12);
            EXPECT_NEAR(last.z / last.w, 1, 1e-12);
            const double w = run.readout("w");
            EXPECT_NEAR(run.readout("depth"), far / (far - near) * (1 - near / w), 1e-6);  // a float's roundings
            // Right behind near it is drawn, with a depth of nearly 0, and before near it is not.
            const double atNear = 4 - (w - near);
            const Picture drawn = run.set("distance", atNear + 1e-4).picture();
            const vec4 clip = clipOf(run, 7);
            if (std::max(std::abs(clip.x), std::abs(clip.y)) < clip.w) {  // not beside the view
                ++crossed;
                EXPECT_TRUE(markedAt(drawn)) << near;
                EXPECT_NEAR(run.readout("depth"), 0, 2e-4 / near);
            }
            const Picture clipped = run.set("distance", atNear - 1e-4).picture();
            EXPECT_FALSE(run.measured("depth"));
            EXPECT_FALSE(markedAt(clipped));
        }
    }
    EXPECT_GE(crossed, 2);
}

TEST(Pipeline, rows_for_columns) {
    DemoRun run("pipeline");
    run.picture();
    const mat4 right = run.matrix("worldFromModel");
    run.set("matrices", "slide-model").picture();
    const mat4 slide = run.matrix("worldFromModel");
    EXPECT_EQ(slide, glm::transpose(right));
    EXPECT_EQ(vec3(slide[0].w, slide[1].w, slide[2].w), vec3(0.2, 0.1, 0)) << "the position, in the last row";
    for (int i = 0; i < 8; ++i) {
        const vec4 byRow = corner(i) * slide, byColumn = right * corner(i);
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(byRow[k], byColumn[k], 1e-15);  // the same sums in another order
    }
    // As columns: nothing is moved, and w is no longer 1.
    EXPECT_EQ(slide * vec4(0, 0, 0, 1), vec4(0, 0, 0, 1));
    EXPECT_NEAR((slide * corner(7)).w, 1 + half * 0.2 + half * 0.1, 1e-15);
    // The three edges at a corner are no longer of one length.
    const auto length = [&](int from, int to) {
        const vec4 a = slide * corner(from), b = slide * corner(to);
        return glm::length(vec3(a) / a.w - vec3(b) / b.w);
    };
    EXPECT_GT(std::abs(length(7, 6) - length(7, 5)), 0.05);
}

TEST(Pipeline, slide_of_projection) {
    DemoRun run("pipeline");
    const double near = 0.5, far = 10;
    for (const double spin : {0.0, 60.0, 200.0}) {
        run.set("spin-x", spin).set("spin-y", spin / 2);
        EXPECT_GT(cubePixels(run.set("matrices", "right").picture()), 20000);
        EXPECT_EQ(cubePixels(run.set("matrices", "slide-projection").picture()), 0);
        for (int vertex = 0; vertex < 8; ++vertex) EXPECT_LT(clipOf(run, vertex).w, 0);
    }
    const mat4 slide = run.matrix("clipFromCamera");
    const vec4 atNear = slide * vec4(0, 0, -near, 1);
    EXPECT_EQ(atNear.w, -near);
    EXPECT_NEAR(atNear.z / atNear.w, 2 * far / (far - near), 1e-14);  // not 0, where its depth begins
    const vec4 ahead = slide * vec4(0, 0, near, 1), farAhead = slide * vec4(0, 0, far, 1);
    EXPECT_NEAR(ahead.z / ahead.w, 0, 1e-14);  // for an eye that looks along +z it is right
    EXPECT_NEAR(farAhead.z / farAhead.w, 1, 1e-14);
}

TEST(Pipeline, one_product_far_out) {
    DemoRun run("pipeline");
    const auto error = [&](const char* products, double offset) {
        run.set("products", products).set("offset", offset).picture();
        return run.readout("float-error");
    };
    EXPECT_GT(error("shader", 1e6), 1);
    EXPECT_GT(error("single", 1e6), 1);
    for (const double offset : {0.0, 1e4, 1e6, 1e8}) EXPECT_LT(error("once", offset), 1e-3) << offset;
    for (const char* products : {"shader", "single"}) EXPECT_LT(error(products, 0), 1e-3);
    // The study: all points of the cube.
    const StudyRun result = runStudy(stage(), *findDemo("pipeline").study, {.timed = false});
    EXPECT_EQ(result.rows.size(), 15U);
    for (const StudyRow& row : result.rows) {
        ASSERT_TRUE(row.ok()) << row.method << " " << row.parameter << ": " << row.status;
        const double offset = std::stod(row.parameter);
        if (row.method == "one product, double matrices") {
            EXPECT_LT(row.all.max, 1e-3) << offset;  // some 10 roundings of 2^-24 of 560 px
        } else if (offset >= 1e6) {
            EXPECT_GT(row.all.rms, 0.5) << row.method;
        }
    }
}
