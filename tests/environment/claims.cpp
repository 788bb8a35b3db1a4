// The claims of environment, and a test for each.
//
// - [rays-are-right] By rays each pixel of the sphere has the colour of double precision, for each material.
// - [off-by-distance] A room of twice the size halves the error of a lookup by direction alone, or leaves at most 0.71 of it.
// - [walls-corrected] A lookup where the ray meets the room's walls gets the walls right, but not the balls before them.
// - [no-seams] Seamless cubes show no jump at the cube's edges; faces that end by themselves show the edges.
// - [kept] No face is drawn while nothing moves; a moving ball redraws only the faces that it is or was in.
// - [total-reflection] In a bubble, beyond the limiting angle, everything is mirrored, and nothing shines through.
// - [no-surface] Glass with the index of its surroundings cannot be seen.
// - [indices] Water, glass and diamond reflect ((n - 1) / (n + 1))^2 head on, and from inside all beyond the angle whose sine is 1/n.
// - [any-length] v - 2 n (n.v) mirrors a v of any length; v + 2 n cos a mirrors unit vectors alone.
// - [own-model] A model of one's own, an OBJ file, is as large as the sphere wherever and however large its corners are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "environment/shiny_sphere.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/functions.h"
#include "mv/image/file.h"
#include "mv/math/reflect.h"
#include "mv/paper/audit.h"
#include "support/demo_run.h"
#include "support/temporary_folder.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int side = 200;

std::vector<float> drawn(DemoRun& run) {
    (void)run.picture();
    return stage().measure(1);
}

// The same pixels, as double precision finds them by rays.
std::vector<double> byRays(DemoRun& run, const std::string& material, int innerReflections = 0) {
    const Demo& demo = run.demo();
    const ShinySphere sphere{.room = {demo.number("room"), demo.number("ball") + 1},
                             .coating = {.kind = material == "mirror"  ? Coating::Kind::mirror
                                                 : material == "glass" ? Coating::Kind::glass
                                                                       : Coating::Kind::metal,
                                         .metal = material == "copper" ? copper : gold,
                                         .index = demo.number("index")},
                             .innerReflections = innerReflections};
    return sphere.picture(demo.scene(FrameInfo(1, side, side)), side, side);
}

struct Apart {
    double rms = 0;
    double typical = 0;  // that 95 of 100 pixels do not reach
    long pixels = 0;
};
Apart difference(const std::vector<float>& shown, const std::vector<double>& exact) {
    Apart result;
    std::vector<double> all;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        // The two must agree on what is the sphere's middle, but for the pixels on its rim.
        if (exact[i] < 0 || shown[i] < 0) continue;
        all.push_back(std::abs(exact[i] - double(shown[i])));
        result.rms += all.back() * all.back();
    }
    EXPECT_GT(all.size(), std::size_t(side * side / 8));
    std::sort(all.begin(), all.end());
    result.pixels = long(all.size());
    result.rms = std::sqrt(result.rms / double(all.size()));
    result.typical = all.empty() ? HUGE_VAL : all[all.size() * 95 / 100];
    return result;
}

// The direction in which the sphere reflects each pixel's line of sight; 0 where it misses.
std::vector<vec3> reflections(DemoRun& run) {
    const Scene camera = run.demo().scene(FrameInfo(1, side, side));
    const mat4 worldFromClip = glm::inverse(camera.clipFromWorld());
    const vec3 eye(glm::inverse(camera.viewFromWorld)[3]);
    std::vector<vec3> ways;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const vec4 far = worldFromClip * vec4((2 * x + 1.0) / side - 1, 1 - (2 * y + 1.0) / side, 1, 1);
            const vec3 way = glm::normalize(vec3(far) / far.w - eye);
            const auto hit = intersectSphere(Ray{eye, way}, vec3(0), 1.0);
            ways.push_back(hit ? reflected(way, glm::normalize(eye + hit->near * way)) : vec3(0));
        }
    }
    return ways;
}

}  // namespace

// The shader's floats: a place in the room is good to 1e-6 of its size, and tiles change by 25 a room's size at most; sums of
// unit vectors, roots and quotients near the rim leave some ten such roundings more. An edge of a wall or a ball may pass
// on the other side of a pixel's middle: 1 pixel in 20 may be off.
constexpr double floats = 5e-4;

TEST(EnvironmentFull, rays_are_right) {
    DemoRun run("environment", side, side);
    run.set("lookup", "rays");
    for (const double room : {2.0, 30.0}) {
        run.set("room", room);
        for (const std::string material : {"mirror", "gold", "copper"}) {
            run.set("material", material);
            EXPECT_LE(difference(drawn(run), byRays(run, material)).typical, floats) << material << " " << room;
        }
        run.set("material", "glass");
        for (const double index : {0.75, 1.1, 1.5, 2.4}) {
            run.set("index", index).set("refract", "both");
            EXPECT_LE(difference(drawn(run), byRays(run, "glass")).typical, floats) << index << " " << room;
            run.set("refract", "inside");
            EXPECT_LE(difference(drawn(run), byRays(run, "glass", 4)).typical, floats) << index << " " << room;
        }
    }
}

TEST(EnvironmentFull, off_by_distance) {
    DemoRun run("environment", side, side);
    double before = difference(drawn(run.set("room", 12)), byRays(run, "mirror")).rms;
    for (const double room : {24.0, 48.0, 96.0}) {
        const double now = difference(drawn(run.set("room", room)), byRays(run, "mirror")).rms;
        // Moved by half as much, smooth tiles are off by half as much; of an edge half as many pixels are wrong, whose root
        // mean square is 0.71 of what it was. A tenth is for which pixels these are.
        EXPECT_LT(now, 0.71 * 1.1 * before) << room;
        EXPECT_GT(now, 0.5 / 1.1 * before) << room;
        before = now;
    }
}

TEST(EnvironmentFull, walls_corrected) {
    DemoRun run("environment", side, side);
    for (const double room : {2.0, 4.0, 16.0}) {
        run.set("room", room);
        const auto exact = byRays(run, "mirror");
        const Apart plain = difference(drawn(run.set("lookup", "direction")), exact);
        // Off by what bilinear filtering of 256 texels a side makes of tiles, which change by 0.2 within 0.04 of a wall: from
        // one texel to the next, 90/256 degrees, by 0.03, of which it rounds off less than a fifth; and by 8 bits.
        const Apart walls = difference(drawn(run.set("lookup", "walls")), exact);
        EXPECT_LT(walls.typical, 0.01) << room;
        EXPECT_GT(plain.typical, 10 * walls.typical) << room;
    }
    // A ball stands before the walls, and there the lookup is of another place.
    run.set("room", 2).set("ball", 0);
    const auto exact = byRays(run, "mirror");
    const auto shown = drawn(run.set("lookup", "walls"));
    long wrong = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (exact[i] >= 0 && shown[i] >= 0 && std::abs(exact[i] - double(shown[i])) > 0.05) ++wrong;
    }
    EXPECT_GT(wrong, 50);
}

TEST(Environment, no_seams) {
    DemoRun run("environment", side, side);
    run.set("cube-size", 16).set("split", "off").set("distance", -2).set("spin-x", 20).set("spin-y", 30);
    const auto ways = reflections(run);
    // Steps from a pixel to the next, as luminance a radian: within a face, and from one face to another.
    const auto steepest = [&](const char* seamless) {
        const auto shown = drawn(run.set("seamless", seamless));
        std::pair<double, double> steps{0, 0};
        for (std::size_t i = 1; i < ways.size(); ++i) {
            if (i % side == 0 || shown[i] < 0 || shown[i - 1] < 0) continue;
            const double angle = std::acos(std::clamp(glm::dot(ways[i], ways[i - 1]), -1.0, 1.0));
            const double step = std::abs(double(shown[i]) - double(shown[i - 1])) / angle;
            const bool crosses = cubePlace(ways[i]).face != cubePlace(ways[i - 1]).face;
            double& most = crosses ? steps.second : steps.first;
            most = std::max(most, step);
        }
        return steps;
    };
    const auto [within, across] = steepest("on");
    EXPECT_GT(across, 0);
    EXPECT_LE(across, within);
    if (isEs()) return;  // which has no other way
    const auto [withinAlone, acrossAlone] = steepest("off");
    EXPECT_GT(acrossAlone, 2 * withinAlone);
}

TEST(EnvironmentFull, kept) {
    DemoRun run("environment", side, side);
    const auto faces = [&](int frame) {
        (void)run.picture(frame);
        return run.readout("faces-drawn");
    };
    (void)faces(1);
    EXPECT_EQ(faces(1), 0);
    const Picture kept = run.picture(1);
    // A step of the ball: it is in one face and perhaps in its neighbours.
    const double step = faces(2);
    EXPECT_GE(step, 1);
    EXPECT_LE(step, 3);
    // A jump: in those that it left, too, and nothing of it is left there.
    run.set("ball", 100);
    const double jump = faces(2);
    EXPECT_GE(jump, 2);
    EXPECT_LT(jump, 6);
    const Picture jumped = run.picture(2);
    EXPECT_EQ(differentPixels(run.set("keep", "off").picture(2), jumped), 0);
    EXPECT_EQ(faces(2), 6);
    EXPECT_EQ(faces(2), 6);
    // No frame draws a face while the ball rests; and what was kept is what is made anew.
    run.set("keep", "on").set("moving", "off").set("ball", -7);
    (void)faces(1);
    EXPECT_EQ(faces(50), 0);
    run.set("moving", "on");
    EXPECT_EQ(differentPixels(run.picture(1), kept), 0);

    // The calls themselves tell: a still frame is one pass, and its draws are those of the picture.
    const AuditReport report = auditDemo(stage(), findDemo("environment"), {}, 1);
    EXPECT_EQ(report.first.passes, 7);
    EXPECT_EQ(report.steady.passes, 1);
    EXPECT_GE(report.first.draws, report.steady.draws + 6);
}

TEST(Environment, total_reflection) {
    DemoRun run("environment", side, side);
    run.set("lookup", "rays").set("material", "glass").set("index", 0.75);
    const auto bubble = drawn(run);
    EXPECT_NEAR(run.readout("limit"), degrees(std::asin(0.75)), 1e-9);
    const auto mirror = drawn(run.set("material", "mirror"));
    const auto ways = reflections(run);
    const vec3 eye(glm::inverse(run.demo().scene(FrameInfo(1, side, side)).viewFromWorld)[3]);
    const mat4 worldFromClip = glm::inverse(run.demo().scene(FrameInfo(1, side, side)).clipFromWorld());
    long beyond = 0, before = 0, differ = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const std::size_t i = pixelIndex(x, y, side);
            if (bubble[i] < 0) continue;
            const vec4 far = worldFromClip * vec4((2 * x + 1.0) / side - 1, 1 - (2 * y + 1.0) / side, 1, 1);
            // How far from the middle the line of sight passes is the sine of its angle with the normal.
            const double sine = glm::length(glm::cross(eye, glm::normalize(vec3(far) / far.w - eye)));
            if (sine > 0.7501) {
                EXPECT_EQ(bubble[i], mirror[i]) << x << " " << y;
                ++beyond;
            } else if (sine < 0.7) {
                differ += std::abs(bubble[i] - mirror[i]) > 0.02F ? 1 : 0;
                ++before;
            }
        }
    }
    EXPECT_GT(beyond, 1000);
    EXPECT_GT(differ, before / 2);
}

TEST(EnvironmentFull, no_surface) {
    // The picture with the glass is the one with the sphere's place empty: what a ray from the eye sees of the room.
    DemoRun run("environment", side, side);
    run.set("lookup", "rays").set("material", "glass").set("index", 1).set("room", 8);
    const auto shown = drawn(run);
    const Scene camera = run.demo().scene(FrameInfo(1, side, side));
    const mat4 worldFromClip = glm::inverse(camera.clipFromWorld());
    const vec3 eye(glm::inverse(camera.viewFromWorld)[3]);
    const Room room{8, run.demo().number("ball") + 1};
    std::vector<double> empty;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const vec4 far = worldFromClip * vec4((2 * x + 1.0) / side - 1, 1 - (2 * y + 1.0) / side, 1, 1);
            // From the sphere on, since a ball before it would hide it.
            const vec3 way = glm::normalize(vec3(far) / far.w - eye);
            const vec3 light = room.seenAlong({eye - glm::dot(eye, way) * way, way});
            const bool counts = shown[pixelIndex(x, y, side)] >= 0;
            empty.push_back(counts ? glm::dot(light, vec3(0.2126, 0.7152, 0.0722)) : -1);
        }
    }
    EXPECT_LE(difference(shown, empty).typical, floats);
    EXPECT_EQ(run.readout("head-on"), 0);
    // Nor is there a black pixel, as NaN would be, where a teapot's interpolated normals turn away from the eye.
    EXPECT_EQ(countPixels(run.set("body", "teapot").picture(), {0, 0, 0}), 0);
    run.set("body", "sphere");
    EXPECT_GT(difference(drawn(run.set("index", 1.05)), empty).typical, 10 * floats);
}

TEST(EnvironmentFull, own_model) {
    const TemporaryFolder folder;
    const auto written = [&](const char* name, const MeshData& mesh, double times, const vec3& moved) {
        std::ostringstream text;
        text.precision(17);
        for (const fvec3& position : mesh.positions) {
            const vec3 at = times * vec3(position) + moved;
            text << "v " << at.x << " " << at.y << " " << at.z << "\n";
        }
        for (const fvec3& n : mesh.normals) text << "vn " << n.x << " " << n.y << " " << n.z << "\n";
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            text << "f";
            for (std::size_t k = i; k < i + 3; ++k) text << " " << mesh.indices[k] + 1 << "//" << mesh.indices[k] + 1;
            text << "\n";
        }
        writeFileAtomically(folder / name, text.str());
        return (folder / name).string();
    };
    DemoRun run("environment", side, side);
    run.set("around", "sky").set("material", "gold");
    const Picture exact = run.picture();
    const MeshData ball = sphere(1, 128, 64);
    const Picture asFile = run.set("model", written("ball.obj", ball, 1, vec3(0))).picture();
    // Cells of a 128th of a turn are off by 1 - cos(pi / 128), 0.0003 of the radius: the sky is the same but at edges, and the outline
    // is. Its pixels are 2 pi times the radius, which is less than a third of the side.
    long off = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Pixel a = exact.at(x, y), b = asFile.at(x, y);
            off += std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)}) > 8;
        }
    }
    EXPECT_LT(off, 2 * pi * side / 3);
    EXPECT_GT(differentPixels(run.set("material", "mirror").picture(), asFile), 1000) << "it has the material";
    run.set("material", "gold");

    // Times a power of two and moved by whole numbers, corners on a grid of 1/1024 are told apart exactly as before.
    MeshData grid = ball;
    for (fvec3& position : grid.positions) position = glm::round(position * 1024.0F) / 1024.0F;
    const Picture onGrid = run.set("model", written("grid.obj", grid, 1, vec3(0))).picture();
    // (Another model comes between, so that no picture is of one that was kept.)
    EXPECT_GT(differentPixels(run.set("model", written("eight.obj", sphere(1, 4, 2), 1, vec3(0))).picture(), onGrid),
              1000);
    EXPECT_EQ(differentPixels(run.set("model", written("far.obj", grid, 64, vec3(1000, -300, 77))).picture(), onGrid),
              0);

    // A model without size is refused.
    writeFileAtomically(folder / "point.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
    EXPECT_NE(run.set("model", (folder / "point.obj").string()).refusal(), "");
}

TEST(EnvironmentFull, indices) {
    DemoRun run("environment", side, side);
    run.set("material", "glass");
    for (const double n : {1.0003, 1.3333, 1.5, 2.417}) {
        (void)run.set("index", n).picture();
        const double part = std::pow((n - 1) / (n + 1), 2);
        // n - 1 of air has lost four of sixteen digits.
        EXPECT_NEAR(run.readout("head-on"), part, 1e-11 * part) << n;
        (void)run.set("index", 1 / n).picture();
        EXPECT_NEAR(std::sin(radians(run.readout("limit"))), 1 / n, 1e-12) << n;
    }
}

TEST(Environment, any_length) {
    const vec3 normal = glm::normalize(vec3(1, 2, 2));
    for (const double length : {1.0, 3.0, 1e-3}) {
        const vec3 way = length * glm::normalize(vec3(0.3, -1, 0.2));
        const double cosine = -glm::dot(glm::normalize(way), normal);
        // In the plane of v and n, as long, and leaving at the angle at which v arrives: roundings of a sum of three
        const vec3 mirrored = reflected(way, normal), slides = way + 2 * cosine * normal;
        EXPECT_NEAR(glm::length(mirrored), length, 4e-16 * length);
        EXPECT_NEAR(glm::dot(mirrored, normal), length * cosine, 4e-16 * length);
        EXPECT_EQ(glm::distance(mirrored, slides) < 1e-14, length == 1) << length;
    }
}
