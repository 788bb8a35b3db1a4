// The claims of shadow-volume, and a test for each.
//
// - [exact] With z-fail no pixel of any scene differs from the rays' picture, except in the band of one pixel at edges.
// - [eye-in-volume] With the eye in a volume z-pass is wrong nearly everywhere, z-fail and a counted start are right.
// - [silhouette-is-enough] Drawing out every triangle gives the same shadow, with many times the triangles.
// - [counts-are-rays] The stencil buffer holds the number of surfaces between each pixel and the light.
// - [three-hundred-shells] 255, 256 and 300 nested shells are exact in groups; in one count 256 of them read as lit,
//   and a sentence says so.
// - [light-anywhere] A light at infinity, exactly in the plane of a face, or below the casters: still no pixel wrong (llvmpipe; with
//   other drivers at most one in a thousand, where a side meets the floor at a flat angle).
// - [neighbours-know] The geometry shader finds the edges that the processor finds, of any light, and all of them close to loops where a
//   light is in the plane of faces, or rounding decides; so z-pass counts by it as it does by the processor's volumes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/feedback.h"
#include "mv/gl/gl.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/math/transform.h"
#include "mv/study/study.h"
#include "shadow-volume/neighbours.h"
#include "support/demo_run.h"
#include "support/softpipe.h"

using namespace mv;
using namespace mv::test;

namespace {

// One row of a study in the present settings, at 320 x 240.
StudyRow compareWithRays() {
    Study study = *stage().info().study;
    study.scenes = {{"as set", {}}};
    study.lines = {{"as set", {}}};
    study.width = 320;
    study.height = 240;
    StudyRow row = runStudy(stage(), study, {.timed = false}).rows.at(0);
    EXPECT_EQ(row.status, "ok");
    EXPECT_GT(row.awayFromEdges.n, 10000);  // so that 0 wrong is not 0 of nothing
    return row;
}

// The stencil buffer of the last picture, the upper row first.
std::vector<int> stencilBuffer() {
    const Target& target = stage().front();
    target.bind();
    const int width = target.width(), height = target.height();
    std::vector<unsigned char> bytes(static_cast<std::size_t>(width * height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes.data());
    std::vector<int> counts;
    for (int y = height - 1; y >= 0; --y) {
        const auto row = bytes.begin() + std::ptrdiff_t(y) * width;
        counts.insert(counts.end(), row, row + width);
    }
    return counts;
}

// How many of the nested scene's boxes stand between a point of its floor and its light: slabs, none of the code under
// test.
int boxesBetween(const vec3& point, const vec3& light, int shells) {
    const mat4 objectFromWorld = glm::inverse(translate(0, 0.8, 0) * rotateY(30));
    const vec3 from(objectFromWorld * vec4(point, 1)), to(objectFromWorld * vec4(light, 1));
    int between = 0;
    for (int i = 0; i < shells; ++i) {
        const double half = 0.2 + 0.35 * (i + 1) / shells;
        double enter = 0, leave = 1;
        for (int k = 0; k < 3; ++k) {
            const double a = (-half - from[k]) / (to[k] - from[k]), b = (half - from[k]) / (to[k] - from[k]);
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        between += enter < leave ? 1 : 0;
    }
    return between;
}

constexpr vec3 lightOfCube(-2.2, 3.6, 1.4);  // of the scenes cube and nested

}  // namespace

TEST(ShadowVolumeFull, exact) {
    DemoRun run("shadow-volume");
    for (const char* scene : {"cube", "still-life", "nested"}) {
        for (const char* method : {"z-fail", "z-pass"}) {
            const StudyRow row = (run.set("scene", scene).set("method", method), compareWithRays());
            EXPECT_EQ(row.awayFromEdges.fraction, 0) << scene << ", " << method;
            // In the band, a pixel's middle within rounding of the edge; there are some hundreds of pixels.
            EXPECT_LT(row.all.fraction, 1e-3) << scene << ", " << method;
        }
    }
    // From other sides, along the floor and from below: the far ends of volumes are in view.
    run.set("method", "z-fail").set("scene", "still-life");
    for (const auto& [spinX, spinY] : {std::pair{-20.0, 40.0}, {10, -60}, {50, 0}}) {
        const StudyRow row = (run.set("spin-x", spinX).set("spin-y", spinY), compareWithRays());
        EXPECT_EQ(row.awayFromEdges.fraction, 0) << spinX << ", " << spinY;
    }
}

// X09
TEST(ShadowVolume, eye_in_volume) {
    DemoRun run("shadow-volume");
    for (const char* scene : {"cube", "still-life"}) {
        run.set("scene", scene).set("eye", "in-volume");
        EXPECT_EQ((run.set("method", "z-fail"), compareWithRays()).awayFromEdges.fraction, 0) << scene;
        EXPECT_EQ((run.set("method", "z-pass-started"), compareWithRays()).awayFromEdges.fraction, 0) << scene;
        EXPECT_TRUE(run.messages().empty());
        // One too few everywhere: what is lit counts -1, which is 255, and what is behind one caster 0.
        EXPECT_GT((run.set("method", "z-pass"), compareWithRays()).awayFromEdges.fraction, 0.9) << scene;
        run.picture();
        EXPECT_EQ(run.readout("stencil-max"), 255);
        EXPECT_GT(run.readout("wrong"), 90);
        ASSERT_EQ(run.messages().size(), 1U);
        EXPECT_EQ(run.messages()[0], "The eye is in 1 volume, and z-pass counts from 0: the shadows are wrong.");
    }
}

TEST(ShadowVolumeFull, silhouette_is_enough) {
    DemoRun run("shadow-volume");
    run.set("scene", "cube");
    const StudyRow outline = compareWithRays();
    EXPECT_EQ(countOf(outline, "volume triangles"), 2 * 6 + 4 + 8);  // sides, light cap, dark cap: light on two faces
    const StudyRow each = (run.set("silhouette", "off"), compareWithRays());
    EXPECT_EQ(countOf(each, "volume triangles"), 8 * 4);  // a prism each
    EXPECT_EQ(each.awayFromEdges.fraction, 0);
    run.set("show", "shadow");
    const Picture byTriangles = run.picture();
    EXPECT_EQ(run.readout("extruded-edges"), 12);
    EXPECT_LE(differentPixels(byTriangles, run.set("silhouette", "on").picture()), 3);  // in the edge band
    EXPECT_EQ(run.readout("extruded-edges"), 6);

    // Curved solids: inner sides cancel, but for pixels where the two come out a rounding apart.
    run.set("scene", "still-life");
    const double few = countOf(compareWithRays(), "volume triangles");
    const StudyRow many = (run.set("silhouette", "off"), compareWithRays());
    EXPECT_GT(countOf(many, "volume triangles"), 3 * few);
    EXPECT_LT(many.awayFromEdges.fraction, 5e-4);  // 1e-4 measured
}

TEST(ShadowVolumeFull, counts_are_rays) {
    DemoRun run("shadow-volume");
    run.set("scene", "nested").set("shells", 12).set("show", "count").picture();
    const mat4 worldFromClip = glm::inverse(run.matrix("clipFromView") * run.matrix("viewFromWorld"));
    const vec3 eye(glm::inverse(run.matrix("viewFromWorld"))[3]);
    const std::vector<int> counts = stencilBuffer();
    const int width = stage().front().width(), height = stage().front().height();
    long compared = 0, most = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            // The floor's point behind this pixel's four corners and middle: one count in all, or an edge is in the pixel
            std::array<int, 5> between{};
            bool seen = true;
            for (std::size_t k = 0; k < 5; ++k) {
                const vec2 at = k == 4 ? vec2(0.5) : vec2(k == 1 || k == 3 ? 1 : 0, k >= 2 ? 1 : 0);
                const vec4 ndc((x + at.x) / width * 2 - 1, 1 - (y + at.y) / height * 2, 0, 1);
                vec4 near = worldFromClip * vec4(ndc.x, ndc.y, -1, 1), on = worldFromClip * ndc;
                near /= near.w;
                on /= on.w;
                const double t = near.y / (near.y - on.y);
                const vec3 point = vec3(near) + t * vec3(on - near);
                // The outermost box hides the floor where the way to the eye meets it
                seen = seen && t > 0 && std::abs(point.x) < 9 && std::abs(point.z) < 9 &&
                       boxesBetween(point, eye, 12) == 0;
                between[k] = boxesBetween(point, lightOfCube, 12);
            }
            bool even = true;
            for (const int count : between) even = even && count == between[4];
            if (!seen || !even) continue;
            ++compared;
            most = std::max<long>(most, between[4]);
            ASSERT_EQ(counts[pixelIndex(x, y, width)], between[4]) << x << ", " << y;
        }
    }
    EXPECT_GT(compared, 200000);
    EXPECT_EQ(most, 12);
    EXPECT_EQ(run.readout("stencil-max"), 12);
}

// X10
TEST(ShadowVolumeFull, three_hundred_shells) {
    DemoRun run("shadow-volume");
    run.set("scene", "nested");
    for (const int shells : {255, 256, 300}) {
        run.set("shells", shells).set("groups", "on").set("show", "shadow");
        // For another driver as in light_anywhere
        EXPECT_LE(compareWithRays().awayFromEdges.fraction, onLlvmpipe() ? 0 : 0.001) << shells;
        run.picture();
        EXPECT_TRUE(run.messages().empty());
        const double dark = run.readout("shadow-pixels");
        EXPECT_EQ(run.measured("stencil-max"), shells <= 255);

        // In one count the middle of the shadow wraps round, and a sentence says so before anybody wonders.
        run.set("groups", "off").picture();
        if (shells <= 255) {
            EXPECT_TRUE(run.messages().empty());
            EXPECT_EQ(run.readout("shadow-pixels"), dark);
            continue;
        }
        ASSERT_EQ(run.messages().size(), 1U);
        EXPECT_EQ(run.messages()[0].rfind(std::to_string(shells) + " volumes may lie over one another", 0), 0U);
        EXPECT_LT(run.readout("shadow-pixels"), dark);
        const StudyRow row = compareWithRays();
        EXPECT_GT(row.all.fraction, 0);
        if (shells == 256) {
            EXPECT_GT(row.awayFromEdges.fraction, 1e-3);  // a hole as large as the innermost box's shadow
        }
    }
    // And with the eye in all of them.
    run.set("shells", 300).set("groups", "on").set("eye", "in-volume").set("method", "z-pass-started");
    EXPECT_EQ(compareWithRays().awayFromEdges.fraction, 0);
}

TEST(ShadowVolumeFull, light_anywhere) {
    DemoRun run("shadow-volume");
    for (const char* scene : {"cube", "still-life"}) {
        run.set("scene", scene);
        for (const char* atInfinity : {"off", "on"}) {
            for (const double turn : {0.0, 75.0, -60.0}) {
                for (const double height : {0.3, 1.0}) {
                    run.set("at-infinity", atInfinity).set("light-turn", turn).set("light-height", height);
                    // Another driver may round depths otherwise, and where the light is low a volume's side meets a surface at a
                    // flat angle: as many pixels may differ there as in pictures.
                    EXPECT_LE(compareWithRays().awayFromEdges.fraction, onLlvmpipe() ? 0 : 0.001)
                        << scene << ", " << atInfinity << ", " << turn << ", " << height;
                }
            }
        }
    }
    // As high as the cube, exactly in the plane of its upper face; and below that, where shadows have no end.
    ASSERT_EQ(3.6 * (1 / 3.6), 1);
    run.set("scene", "cube").set("at-infinity", "off").set("light-turn", 0);
    for (const double height : {1 / 3.6, 0.1}) {
        // By the coarse grid: whether a face in the light's plane faces it, and so counts, is for rounding to say.
        run.set("light-height", height).picture();
        EXPECT_EQ(run.readout("wrong"), 0) << height;
        EXPECT_EQ(run.readout("extruded-edges"), 4) << height;  // of one side: the upper face is not lit
    }
}

namespace {

using Place = std::tuple<float, float, float>;
using EdgeRun = std::pair<Place, Place>;  // an edge, as the triangle that faces the light runs it
Place placeOf(const fvec4& p) { return {p.x, p.y, p.z}; }

// The edges that the shader draws out. In clip space the solid is where it is in its own, so that a corner that is captured is one of the
// mesh's positions, bit for bit. A side is a strip b, a, far b, far a of two triangles.
std::multiset<EdgeRun> runsByShader(const ClosedMesh& closed, const vec4& light) {
    const Program program("shadow-volume", "sides");
    const Mesh mesh(withNeighbours(closed), "neighbours");
    program.use();
    program.set("clipFromObject", mat4(1));
    program.set("light", light);
    const Captured sides = captured(GL_TRIANGLES, [&] { mesh.drawAs(GL_TRIANGLES_ADJACENCY); });
    EXPECT_EQ(sides.generated, sides.written);
    std::multiset<EdgeRun> runs;
    for (std::size_t i = 0; i + 5 < sides.positions.size(); i += 6)
        runs.emplace(placeOf(sides.positions[i + 1]), placeOf(sides.positions[i]));
    return runs;
}
std::multiset<EdgeRun> runsByProcessor(const ClosedMesh& closed, const vec4& light) {
    std::multiset<EdgeRun> runs;
    for (const ClosedMesh::Edge& edge : silhouette(closed, light)) {
        const fvec3 &a = closed.positions()[edge.vertex[0]], &b = closed.positions()[edge.vertex[1]];
        runs.emplace(Place(a.x, a.y, a.z), Place(b.x, b.y, b.z));
    }
    return runs;
}
// In a loop each corner is left as often as it is come to.
bool areLoops(const std::multiset<EdgeRun>& runs) {
    std::map<Place, int> balance;
    for (const auto& [from, to] : runs) {
        ++balance[from];
        --balance[to];
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& one) { return one.second == 0; });
}

}  // namespace

TEST(ShadowVolumeFull, neighbours_know) {
    DemoRun run("shadow-volume");  // a context
    if (capturesNothingBehindGeometryShaders()) return;
    const std::vector<ClosedMesh> solids{ClosedMesh(box(vec3(-0.5), vec3(0.5))), ClosedMesh(torus(1, 0.45, 24, 17)),
                                         ClosedMesh(sphere(1, 31, 20))};
    for (const ClosedMesh& solid : solids) {
        EXPECT_EQ(withNeighbours(solid).indices.size(), 6 * solid.triangles().size());
        std::size_t found = 0;
        for (int i = 0; i < 100; ++i) {
            // All round, near and far, and every third one at infinity
            const double height = 2 * (i + 0.5) / 100 - 1, turn = 2.39996 * i, around = std::sqrt(1 - height * height);
            const vec4 light(1.7 * (1 + i % 7) * vec3(around * std::cos(turn), height, around * std::sin(turn)),
                             i % 3 == 0 ? 0 : 1);
            const std::multiset<EdgeRun> runs = runsByShader(solid, light);
            EXPECT_EQ(runs, runsByProcessor(solid, light)) << i;
            found += runs.size();
        }
        EXPECT_GT(found, 400U);
    }
    // A light in the plane of a cube's face: that face is none that faces it
    EXPECT_EQ(runsByShader(solids[0], vec4(0.5, 3, 0.2, 1)), runsByProcessor(solids[0], vec4(0.5, 3, 0.2, 1)));
    // In the planes of the sphere's and the ring's faces themselves, as nearly as a float tells: each face may get either answer, but it
    // is one answer for all who ask
    for (const ClosedMesh& solid : solids) {
        for (std::size_t t = 0; t < solid.triangles().size(); t += 7) {
            const auto& [i, j, k] = solid.triangles()[t];
            const vec3 a(solid.positions()[i]), b(solid.positions()[j]), c(solid.positions()[k]);
            const vec3 light = a + 3.3 * (b - a) + 1.9 * (c - a);
            EXPECT_TRUE(areLoops(runsByShader(solid, vec4(light, 1)))) << t;
            EXPECT_TRUE(areLoops(runsByShader(solid, vec4(light - a, 0)))) << t;
        }
    }
    // In the picture
    for (const char* scene : {"cube", "still-life", "nested"}) {
        for (const char* eye : {"outside", "in-volume"}) {
            run.set("scene", scene).set("eye", eye).set("method", "z-pass-started").set("by", "geometry-shader");
            EXPECT_LE(compareWithRays().awayFromEdges.fraction, onLlvmpipe() ? 0 : 0.001) << scene << ", " << eye;
        }
    }
}
