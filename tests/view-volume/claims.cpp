// The claims of view-volume, and a test for each; the extreme one is X07 in docs/stability.md.
//
// - [planes-are-the-clip-volume] A point is inside the six planes exactly when its clip coordinates are within -w to w.
// - [orange-is-clipped] The parts that the clip volume cuts off are orange, and none of them is left after the projection.
// - [culled-is-not-drawn] An object wholly outside one plane is not drawn, and nothing is missing in the cube.
// - [cube-is-the-picture] The canonical cube, seen from the front, is the camera's picture.
// - [near-takes-the-cube] The nearer near is, the thinner the slice of the cube that is left for what is far away.
// - [parameters-never-cancel] Planes from near and far are exact at any far/near; from the matrix they are not.
// - [onto-a-plane] The first matrices draw a point where its line of sight meets the plane; the shadow's matrix is the same.
// - [two-halves] The projection is the matrix that brings the sides to 45 degrees, and then one of depth alone.
// - [sight-becomes-parallel] Lines of sight become parallel to z, since the eye goes to the point at infinity there.
// - [near-below-far] Near not below far is refused with both.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <vector>

#include "math/support.h"
#include "mv/geometry/ray_caster.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "mv/paper/audit.h"
#include "shared/scenes.h"
#include "support/demo_run.h"
#include "support/random.h"
#include "view-volume/view-volume.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 479, height = 480;  // of a pane: 960 less the line between, halved
const vec3 eye(0, 3, 0);
const std::array<std::string, 9> powers{"1", "10", "100", "1e3", "1e4", "1e5", "1e6", "1e7", "1e8"};

// Clipped things are drawn four fifths orange; nothing else has such a colour.
bool isOrange(const Pixel& p) { return p.red > 205 && p.green > 115 && p.green < 185 && p.blue < 100; }

long orangeIn(const Picture& picture, int left) {
    long count = 0;
    for (int y = 34; y < height - 34; ++y) {
        for (int x = left; x < left + width; ++x) count += isOrange(picture.at(x, y)) ? 1 : 0;
    }
    return count;
}

// The right pane, where the canonical cube is, without the words.
std::vector<Pixel> cubePane(const Picture& picture) {
    std::vector<Pixel> pixels;
    for (int y = 34; y < height - 34; ++y) {
        for (int x = width + 1; x < 2 * width + 1; ++x) pixels.push_back(picture.at(x, y));
    }
    return pixels;
}

}  // namespace

TEST(ViewVolume, planes_are_the_clip_volume) {
    DemoRun run("view-volume");
    Random random(5);
    for (const char* projection : {"perspective", "orthographic"}) {
        for (const char* planes : {"parameters", "matrix", "float-matrix"}) {
            run.set("projection", projection).set("planes", planes).picture();
            const std::vector<double> numbers = run.demo().values();
            ASSERT_EQ(numbers.size(), 24U);
            const mat4 clipFromWorld = run.matrix("clipFromWorld");
            int in = 0, out = 0;
            for (int i = 0; i < 5000; ++i) {
                // Camera space; the camera looks along -z from the eye
                const vec3 point(random.number(-20, 20), random.number(-20, 20), random.number(-40, 5));
                const vec4 clip = clipFromWorld * vec4(point + eye, 1);
                double least = std::numeric_limits<double>::infinity();
                for (std::size_t p = 0; p < 24; p += 4) {
                    const vec3 normal(numbers[p], numbers[p + 1], numbers[p + 2]);
                    EXPECT_NEAR(glm::length(normal), 1, 1e-6);
                    least = std::min(least, glm::dot(normal, point) + 30 * numbers[p + 3]);
                }
                if (std::abs(least) < 1e-4) continue;  // float: 1e-7 of up to 40 m, a few times over
                const bool inside =
                    std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && std::abs(clip.z) <= clip.w;
                EXPECT_EQ(least > 0, inside) << projection << ", " << planes;
                ++(inside ? in : out);
            }
            EXPECT_GT(in, 300);
            EXPECT_GT(out, 300);
        }
    }
}

TEST(ViewVolume, orange_is_clipped) {
    DemoRun run("view-volume");
    const RayCaster caster(garden());
    for (const double pan : {0, 25}) {
        const Picture picture = run.set("cull", "off").set("pan", pan).set("near", 3).picture();
        EXPECT_EQ(orangeIn(picture, width + 1), 0);  // what is left after the projection is inside
        const mat4 clipFromWorld = run.matrix("clipFromWorld");
        const mat4 worldFromPane = glm::inverse(run.matrix("outsideFromWorld"));
        // The thing that a ray through the pixel meets: 0 nothing, 1 what the clip volume holds, 2 what it does not
        const auto met = [&](int x, int y) {
            const vec2 ndc(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height);
            const vec4 a = worldFromPane * vec4(ndc, -1, 1), b = worldFromPane * vec4(ndc, 1, 1);
            const vec3 from = vec3(a) / a.w;
            const auto hit = caster.nearest({from, vec3(b) / b.w - from});
            if (!hit) return 0;
            const vec4 clip = clipFromWorld * vec4(hit->point, 1);
            return std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && std::abs(clip.z) <= clip.w ? 1 : 2;
        };
        // The lines of the view volume and from the eye to it, in pixels
        std::vector<std::array<vec2, 2>> lines;
        const auto pixelOf = [&](const vec3& point) {
            return pixelFromNdc(ndcFromClip(run.matrix("outsideFromWorld") * vec4(point, 1)), width, height);
        };
        const std::array<vec3, 8> corners = viewVolumeCorners(clipFromWorld);
        for (const vec3& a : corners) {
            for (const vec3& b : corners) lines.push_back({pixelOf(a), pixelOf(b)});
            lines.push_back({pixelOf(eye), pixelOf(a)});
        }
        const auto nearestLine = [&](const vec2& pixel) {
            double least = std::numeric_limits<double>::infinity();
            for (const auto& [a, b] : lines) {
                const vec2 along = b - a, to = pixel - a;
                const double length = glm::dot(along, along);
                const double part = length > 0 ? std::clamp(glm::dot(to, along) / length, 0.0, 1.0) : 0;
                least = std::min(least, glm::length(to - part * along));
            }
            return least;
        };
        int orange = 0, plain = 0;
        for (int y = 40; y < height - 40; y += 2) {
            for (int x = 2; x < width - 2; x += 2) {
                const int here = met(x, y);
                // At an edge rounding decides which side a pixel is on
                if (here == 0 || met(x - 1, y) != here || met(x + 1, y) != here || met(x, y - 1) != here ||
                    met(x, y + 1) != here)
                    continue;
                const Pixel pixel = picture.at(x, y);
                if (nearestLine(vec2(x + 0.5, height - y - 0.5)) < 3) continue;
                EXPECT_EQ(isOrange(pixel), here == 2) << x << ", " << y;
                ++(here == 2 ? orange : plain);
            }
        }
        EXPECT_GT(orange, 300);
        EXPECT_GT(plain, 300);
    }
}

TEST(ViewVolumeFull, culled_is_not_drawn) {
    for (const char* projection : {"perspective", "orthographic"}) {
        for (const char* pan : {"0", "25", "-70"}) {
            SCOPED_TRACE(std::string(projection) + ", pan " + pan);
            DemoRun run("view-volume");
            run.set("projection", projection).set("pan", pan);
            const Picture with = run.picture();
            const double drawn = run.readout("drawn"), culled = run.readout("culled");
            EXPECT_EQ(drawn + culled, 29);
            EXPECT_GT(culled, 5);
            // The cube is the same to the last pixel, though less was drawn into it
            const Picture without = run.set("cull", "off").picture();
            EXPECT_EQ(run.readout("culled"), 0);
            EXPECT_EQ(cubePane(with), cubePane(without));
            EXPECT_GT(orangeIn(without, 0), orangeIn(with, 0));
            // And the audit shows it: each is left out of two panes, and of what is drawn all is seen somewhere
            const auto audited = [&](const char* cull) {
                return auditDemo(stage(), findDemo("view-volume"),
                                 {{"projection", projection}, {"pan", pan}, {"cull", cull}}, 1);
            };
            const AuditReport all = audited("off"), kept = audited("on");
            EXPECT_EQ(all.steady.draws - kept.steady.draws, 2 * long(culled));
            // The page's numbers: draws of which no sample is seen
            const auto unseenDraws = [](const AuditReport& report) {
                int draws = 0;
                for (const Finding& finding : report.findings) {
                    if (finding.kind == waste::noSample) draws += finding.times;
                }
                for (const auto& [finding, reason] : report.excused) draws += finding.times;
                return draws;
            };
            EXPECT_GT(unseenDraws(all), unseenDraws(kept));
            if (projection == std::string("perspective") && pan != std::string("-70")) {
                EXPECT_EQ(unseenDraws(all), 34);
                EXPECT_EQ(unseenDraws(kept), pan == std::string("0") ? 0 : 2);
            }
            if (pan == std::string("0")) {
                EXPECT_EQ(unseenDraws(kept), 0);
            }
        }
    }
}

TEST(ViewVolume, cube_is_the_picture) {
    DemoRun run("view-volume");
    run.set("turn", 0).set("tilt", 0).set("pan", 10).picture();
    const mat4 cubeFromWorld = run.matrix("cubeFromClip") * run.matrix("clipFromWorld");
    Random random(6);
    double before = 0;
    for (int i = 0; i < 200; ++i) {
        const vec3 point(random.number(-10, 10), random.number(-2, 10), random.number(-30, -9));
        const vec3 seen = ndcFromClip(run.matrix("clipFromWorld") * vec4(point, 1));
        const vec3 shown = ndcFromClip(cubeFromWorld * vec4(point, 1));
        // Both in units of the cube: 1.9 of them from the middle of the pane to its nearer edges, left and right
        EXPECT_NEAR(shown.x * 1.9, seen.x, 1e-12);
        EXPECT_NEAR(shown.y * 1.9 * height / width, seen.y, 1e-12);
        // Where something is nearer in the one it is in the other
        EXPECT_NEAR(shown.z, seen.z / 4, 1e-12);
        before = std::max(before, std::abs(seen.x));
    }
    EXPECT_GT(before, 0.5);
    // The corners of the volume are the corners of a square
    const std::array<vec3, 8> corners = viewVolumeCorners(run.matrix("clipFromWorld"));
    for (const vec3& corner : corners) {
        const vec3 shown = ndcFromClip(cubeFromWorld * vec4(corner, 1));
        EXPECT_NEAR(std::abs(shown.x) * width, std::abs(shown.y) * height, 1e-9);
        EXPECT_NEAR(std::abs(shown.z), 0.25, 1e-12);
    }
}

TEST(ViewVolume, near_takes_the_cube) {
    DemoRun run("view-volume");
    // The house stands 20 m before the camera; z from there to the far plane
    const auto left = [&](double near, std::size_t closer) {
        run.set("near", near).set("closer", powers[closer]).picture();
        return 1 - ndcFromClip(run.matrix("clipFromWorld") * vec4(0, 3, -20, 1)).z;
    };
    double before = 2;
    for (const double near : {15.0, 8.0, 4.0, 1.0}) {
        const double now = left(near, 0);
        EXPECT_LT(now, before);
        EXPECT_NEAR(now, 2 * near * (30 - 20) / ((30 - near) * 20), 1e-14);  // 1 - z, by the matrix's row 3
        before = now;
    }
    // From there on in proportion to near: a ten thousandth of near has a ten thousandth of the cube
    EXPECT_NEAR(left(1, 6) / left(1, 2), 1e-4, 1e-6);
    // In the box of a parallel projection near takes nothing
    run.set("projection", "orthographic");
    EXPECT_NEAR(left(1, 6), 2 * 10 / 30.0, 1e-6);
}

TEST(ViewVolume, parameters_never_cancel) {
    DemoRun run("view-volume");
    run.set("near", 6).set("far", 60);
    const auto error = [&](const char* planes, std::size_t closer) {
        run.set("planes", planes).set("closer", powers[closer]).picture();
        return run.readout("plane-error");
    };
    for (std::size_t closer = 0; closer <= 8; ++closer) {
        const double farOverNear = std::pow(10.0, double(closer) + 1);
        EXPECT_LT(error("parameters", closer), 3e-16);  // an ulp of 1
        EXPECT_NEAR(run.readout("far-over-near"), farOverNear, 1e-9 * farOverNear);
        // The rest of the far plane's normal is 2 near/far, beside the roundings of numbers near 1
        EXPECT_LT(error("matrix", closer), 3e-16 * farOverNear + 1e-15);
        if (closer <= 6) {
            EXPECT_LT(error("float-matrix", closer), 1.2e-7 * farOverNear);
        }
    }
    EXPECT_GT(error("float-matrix", 6), 1e-2);  // X07
    EXPECT_GT(error("matrix", 8), 1e-12);
    EXPECT_TRUE(run.messages().empty());
    // The page's numbers, with near and far as they are at first
    run.set("near", 8).set("far", 30).set("closer", "1e6").set("planes", "parameters").picture();
    const double right = run.readout("drawn");
    run.set("planes", "float-matrix").picture();
    EXPECT_EQ(run.readout("drawn"), right + 4) << "four trees beyond far";
    EXPECT_NEAR(run.readout("plane-error"), 0.12, 0.005);  // two digits
    run.set("near", 6).set("far", 60);
    // From 1e8 on nothing is left in float: said, and no number is made up
    run.set("planes", "float-matrix").set("closer", "1e7").picture();
    ASSERT_EQ(run.messages().size(), 1U);
    EXPECT_NE(run.messages()[0].find("cancelled to 0 in float"), std::string::npos);
    EXPECT_THROW(run.demo().values(), Error);
}

TEST(ViewVolume, onto_a_plane) {
    view_volume::Settings s;
    Random random(6);
    for (const double near : {0.5, 8.0, 25.0}) {
        s.near = near;
        for (int i = 0; i < 100; ++i) {
            const vec3 p(random.number(-20, 20), random.number(-20, 20), random.number(-60, -0.1));
            // The line from the eye, t p, meets z = -near at t = near / -p.z. Roundings of numbers up to 20 * 25 / 0.1
            s.projection = view_volume::Projection::perspective;
            const vec4 q = planeFromCamera(s) * vec4(p, 1);
            EXPECT_NEAR(glm::length(vec3(q) / q.w - near / -p.z * p), 0, 1e-11);
            s.projection = view_volume::Projection::orthographic;
            EXPECT_EQ(planeFromCamera(s) * vec4(p, 1), vec4(p.x, p.y, 0, 1));
        }
        // The shadow's matrix for a light in the eye and this plane, up to a factor
        s.projection = view_volume::Projection::perspective;
        const mat4 shadow = shadowProjection(vec4(0, 0, 0, 1), vec4(0, 0, 1, near));
        EXPECT_LT(largestDifference(shadow / shadow[0][0], planeFromCamera(s)), 1e-15);
    }
}

TEST(ViewVolume, two_halves) {
    view_volume::Settings s;
    for (const auto projection : {view_volume::Projection::perspective, view_volume::Projection::orthographic}) {
        s.projection = projection;
        for (const double near : {0.5, 8.0, 25.0}) {
            s.near = near;
            // Numbers of at most 2 f n/(f - n) = 300, each from a few products
            EXPECT_LT(largestDifference(clipFromSides(s) * sidesFromCamera(s), clipFromCamera(s)), 1e-12);
        }
    }
    // The upper edge of the pyramid comes to 45 degrees
    s.projection = view_volume::Projection::perspective;
    const vec4 edge = sidesFromCamera(s) * vec4(0, std::tan(radians(view_volume::fovy / 2)), -1, 1);
    EXPECT_NEAR(edge.y, -edge.z, 1e-15);
}

TEST(ViewVolume, sight_becomes_parallel) {
    const mat4 clip = clipFromCamera(view_volume::Settings{});
    const vec4 eyeAt = clip * vec4(0, 0, 0, 1);
    EXPECT_EQ(vec3(eyeAt.x, eyeAt.y, eyeAt.w), vec3(0));
    EXPECT_NE(eyeAt.z, 0);
    const auto lines = view_volume::sightLines(view_volume::Settings{});
    ASSERT_EQ(lines.size(), 9U);
    for (const auto& [first, last] : lines) {
        EXPECT_NEAR(glm::length(glm::cross(glm::normalize(first), glm::normalize(last))), 0, 1e-15) << "from the eye";
        const vec3 begin = ndcFromClip(clip * vec4(first, 1)), end = ndcFromClip(clip * vec4(last, 1));
        EXPECT_NEAR(glm::length(vec2(begin) - vec2(end)), 0, 1e-15);  // a few roundings of numbers below 1
        EXPECT_NEAR(begin.z, -1, 1e-15);
        EXPECT_NEAR(end.z, 1, 1e-15);
    }
    // The words are drawn in each pane: more of their colour than the squares of 5 x 5 pixels at their beginnings have
    DemoRun run("view-volume");
    const Pixel sight{140, 26, 153};
    EXPECT_EQ(countPixels(run.picture(), sight), 0);
    const Picture with = run.preset("sight-lines").picture();
    std::array<long, 2> drawn{};
    for (int y = 0; y < with.height; ++y) {
        for (int x = 0; x < with.width; ++x)
            drawn.at(2 * x < with.width ? 0 : 1) += sameColor(with.at(x, y), sight) ? 1 : 0;
    }
    for (const long pixels : drawn) EXPECT_GT(pixels, 9 * 25);
}

TEST(ViewVolume, near_below_far) {
    DemoRun run("view-volume");
    EXPECT_EQ(run.set("near", 20).set("far", 20).refusal(), "--near: must be less than --far 20, 20");
    EXPECT_EQ(run.set("far", 20.5).refusal(), "");
    // Planes from the matrix, beyond what double leaves of them
    run.set("near", 0.5).set("far", 60).set("closer", "1e8").set("planes", "matrix");
    EXPECT_EQ(run.refusal().rfind("--closer: must leave the matrix its planes; planesFromClip: the far plane's", 0),
              0U);
    EXPECT_EQ(run.set("planes", "parameters").refusal(), "");
}
