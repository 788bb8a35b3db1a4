// The claims of procedural, and a test for each; X52 in docs/stability.md is a pattern 2^24 from the origin.
//
// - [no-texels] At a zoom of a million, with the origin near, each pixel has the value of double precision.
// - [float-breaks] With the origin far, neighbouring pixels round to the same point, and the picture falls into blocks.
// - [near-is-far] The pattern 2^24 from the origin is computed as exactly as before if the origin is near.
// - [finer-by-name] In a small picture the audit names each octave that is finer than every pixel; leave-out computes none.
// - [goes-through] A body is cut out of its pattern: the same point has the same number on the sphere and on the wall.
// - [texels-of-the-formula] A 3D texture has the formula's number at the middle of each texel, to half a step of a byte, and between
//   two middles the straight line, at any distance from the origin.
// - [one-resolution] Zoomed in, a texture shows straight lines from texel to texel, where the formula goes on.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mv/math/transform.h"
#include "mv/paper/audit.h"
#include "shared/procedural.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 160, height = 120;

struct Named {
    const char* name;
    Pattern pattern;
};
constexpr std::array<Named, 4> patterns{
    {{"brick", Pattern::brick}, {"wood", Pattern::wood}, {"marble", Pattern::marble}, {"noise", Pattern::noise}}};

// The demo's picture, as numbers, the upper row first.
std::vector<float> drawn(DemoRun& run) {
    (void)run.picture();
    return stage().measure(1);
}

// The wall in double precision: the offset of a pixel's middle, as the demo's header says it.
vec3 onWall(int x, int y, double zoom) {
    return {(2 * (x + 0.5) / width - 1) * 1.5 * width / height / zoom, (1 - 2 * (y + 0.5) / height) * 1.5 / zoom, 0};
}

// The largest difference of all pixels but the part that may be wrong since an edge runs through their middles.
double largestOff(const std::vector<float>& shown, const PatternPlace& place, double zoom, double mayBeWrong = 0) {
    std::vector<vec3> offsets;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) offsets.push_back(onWall(x, y, zoom));
    }
    const auto truth = patternAt(place, offsets);
    std::vector<double> off;
    for (std::size_t i = 0; i < truth.size(); ++i) off.push_back(std::abs(truth[i] - double(shown[i])));
    std::sort(off.begin(), off.end());
    return off[off.size() - 1 - static_cast<std::size_t>(mayBeWrong * double(off.size()))];
}

// An octave's points are up to 32 cells from its middle, where floats are 2e-6 apart. Its noise changes by 4 a cell at most
// and has the weight 1/16, so five of them are off by 3e-6; marble and wood bend by that, and go round pi times as fast:
// 1e-5. Rings of wood that are counted in floats, 4 times 2e-7 times pi, and the sums' own roundings are some 5e-6 more.
constexpr double floats = 2e-5;

}  // namespace

TEST(ProceduralFull, no_texels) {
    for (const Named& one : patterns) {
        DemoRun run("procedural", width, height);
        run.set("view", "wall").set("pattern", one.name);
        for (const double zoom : {1.0, 1e3, 1e6}) {
            const auto shown = drawn(run.set("zoom", zoom));
            // A brick's edge through a pixel's middle may be judged otherwise: the wall has a row of pixels of them.
            const double atEdges = one.pattern == Pattern::brick ? 0.02 : 0;
            const PatternPlace place{one.pattern, 5, std::log2(zoom), patternCentre(0)};
            EXPECT_LE(largestOff(shown, place, zoom, atEdges), floats) << one.name << " " << zoom;
        }
    }
}

TEST(Procedural, float_breaks) {
    DemoRun run("procedural", width, height);
    run.set("view", "wall").set("pattern", "noise").set("zoom", 1e6);
    const auto columns = [&](const char* origin) {
        const auto shown = drawn(run.set("origin", origin));
        return std::set<float>(shown.begin(), shown.begin() + width).size();
    };
    const std::size_t near = columns("near");
    EXPECT_GT(near, std::size_t(width * 9 / 10));
    // A row has as many different points as there are floats across it, and one more at each end; its height, which is
    // interpolated, may round to two.
    const std::size_t far = columns("far");
    EXPECT_LE(double(far), 2 * (3.0 * width / height / 1e6 / run.readout("float-step") + 2));
    EXPECT_LT(far, near / 3);
    EXPECT_GT(run.readout("float-step"), 3 * run.readout("pixel"));
}

TEST(ProceduralFull, near_is_far) {
    for (const Named& one : patterns) {
        DemoRun run("procedural", width, height);
        run.set("view", "wall").set("pattern", one.name).set("distance", 16'777'216);
        const PatternPlace place{one.pattern, 5, 0, patternCentre(16'777'216)};
        const double atEdges = one.pattern == Pattern::brick ? 0.02 : 0;
        // The rings of wood are there 7e7 times round: double itself has 1e-8 of one.
        EXPECT_LE(largestOff(drawn(run), place, 1, atEdges), floats) << one.name;
        EXPECT_GT(largestOff(drawn(run.set("origin", "far")), place, 1, atEdges), 0.1) << one.name;
    }
}

TEST(ProceduralFull, finer_by_name) {
    DemoInfo made = findDemo("procedural");
    made.width = 64, made.height = 48;
    const auto named = [&](const char* filter) {
        const AuditReport report = auditDemo(stage(), made, {{"octaves", "8"}, {"filter", filter}}, 1);
        std::vector<std::string> names;
        for (const Finding& finding : report.findings) names.push_back(finding.what);
        return names;
    };
    // The sphere's nearest point is 2.9 before the eye, where a pixel is 0.044 wide. A wave is two cells long: of frequency 64
    // it is shorter than that. Four samples across a pixel are nearer to each other than any.
    const std::vector<std::string> two{"octave of frequency 64, finer than every pixel",
                                       "octave of frequency 128, finer than every pixel"};
    EXPECT_EQ(named("none"), two);
    EXPECT_EQ(named("samples"), std::vector<std::string>());
    EXPECT_EQ(named("leave-out"), std::vector<std::string>());
    made.height = 600, made.width = 800;
    EXPECT_EQ(named("none"), std::vector<std::string>());
}

TEST(Procedural, goes_through) {
    DemoRun run("procedural", width, height);
    run.set("pattern", "marble").set("octaves", 1);
    const PatternPlace place{Pattern::marble, 1, 0, patternCentre(0)};
    for (const double turn : {0.0, 130.0}) {
        const auto shown = drawn(run.set("turn", turn));
        const mat4 bodyFromClip = glm::inverse(run.demo().scene(FrameInfo(1, width, height)).clipFromWorld());
        int asked = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const vec2 at(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height);
                const vec4 near = bodyFromClip * vec4(at, -1, 1), far = bodyFromClip * vec4(at, 0.5, 1);
                const vec3 a = vec3(near) / near.w, way = glm::normalize(vec3(far) / far.w - a);
                const double along = -glm::dot(a, way), square = glm::dot(a, a) - along * along;
                if (square > 1) continue;  // near the outline the mesh is not the sphere
                const vec3 point = a + (along - std::sqrt(1.69 - square)) * way;
                // The mesh lies up to 0.002 within the sphere; marble of one octave changes by 2 pi (1 + 1.5 * 2) / 2 a unit.
                EXPECT_NEAR(shown[pixelIndex(x, y, width)], patternAt(place, point), 0.002 * 13) << x << " " << y;
                ++asked;
            }
        }
        EXPECT_GT(asked, 1000);
    }
}

TEST(Procedural, texels_of_the_formula) {
    // Texels' middles lie at the wall's left and right edges and evenly between them. So each pixel's place between eight of them
    // is known, and what it shows is the mean of the formula's bytes there.
    DemoRun run("procedural", width, height);
    run.set("view", "wall").set("source", "texture").set("texels", "16");
    for (const Named& one : patterns) {
        run.set("pattern", one.name);
        for (const double distance : {0.0, 16'777'216.0}) {
            const auto shown = drawn(run.set("distance", distance));
            const PatternPlace place{one.pattern, 5, 0, patternCentre(distance)};
            const double side = 3.0 * width / height, step = side / 15;
            const auto byteAt = [&](int i, int j, int k) {
                const vec3 middle(i * step - side / 2, j * step - side / 2, k * step - side / 2);
                return double(std::lround(255 * patternAt(place, middle))) / 255;
            };
            double largest = 0;
            for (int y = 0; y < height; y += 7) {
                for (int x = 0; x < width; x += 7) {
                    const vec3 at = (onWall(x, y, 1) + side / 2) / step, low = glm::floor(at), part = at - low;
                    double mean = 0;
                    for (int corner = 0; corner < 8; ++corner) {
                        const int a = corner & 1, b = (corner >> 1) & 1, c = corner >> 2;
                        mean += (a == 1 ? part.x : 1 - part.x) * (b == 1 ? part.y : 1 - part.y) *
                                (c == 1 ? part.z : 1 - part.z) * byteAt(int(low.x) + a, int(low.y) + b, int(low.z) + c);
                    }
                    largest = std::max(largest, std::abs(mean - double(shown[pixelIndex(x, y, width)])));
                }
            }
            // A driver weighs by parts of 1/256 at least, in each of three directions, and keeps 8 bits: 4/256 in all.
            EXPECT_LT(largest, 4.0 / 256) << one.name << " " << distance;
        }
    }
}

TEST(Procedural, one_resolution) {
    DemoRun run("procedural", width, height);
    constexpr double zoom = 8, texels = 32, side = 3.0 * width / height, step = side / (texels - 1);
    run.set("view", "wall").set("pattern", "noise").set("zoom", zoom).set("octaves", 8).set("endless", "off");
    // From each texel to the next, some 40 pixels: how far the row leaves the straight line between the first and the last of them
    const auto leaves = [&](const char* source) {
        const auto shown = drawn(run.set("source", source).set("texels", texels));
        const auto texelOf = [&](int x) { return std::floor((onWall(x, 0, zoom).x + side / 2) / step); };
        double most = 0;
        for (int first = 0; first < width;) {
            int end = first + 1;
            while (end < width && texelOf(end) == texelOf(first)) ++end;
            const double low = double(shown[std::size_t(first)]), high = double(shown[std::size_t(end) - 1]);
            for (int x = first; x < end; ++x) {
                const double line = low + (high - low) * (x - first) / std::max(1, end - 1 - first);
                most = std::max(most, std::abs(double(shown[std::size_t(x)]) - line));
            }
            first = end;
        }
        return most;
    };
    EXPECT_LT(leaves("texture"), 3.0 / 256);  // a driver's weights have 8 bits
    EXPECT_GT(leaves("formula"), 6.0 / 256);
}
