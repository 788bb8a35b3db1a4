// The claims of ray-cast, and a test for each.
//
// - [like-the-raster] Away from edges, which hold 5 % of the pixels at most, no pixel has another object or colour than GL's.
// - [through-the-middle] The ray of a pixel goes through its middle, and u, v, w are a right-handed frame.
// - [nearest-first] Candidates come in order of t, and the pixel has the colour of the first.
// - [three-planes] Implicit, by point and normal, and parametric: the plane's three forms give one picture.
// - [slips-show] The printed forms of the implicit plane and the triangle are wrong in the picture, the mended ones right. The other
//   objects have no slip that a picture shows.
// - [same-t-in-both-spaces] A ray taken to an object's space, and not normalized again, meets it at the t of the world.
// - [textbook-fails-far] In float the textbook's sphere is wrong in over a tenth of its pixels 1e4 away; the stable one in none.
// - [newton-needs-a-start] From one start Newton's method misses parts of the flag; from a grid of 12 by 12 a tenth of them
//   at most.
// - [raster-by-hand] The same triangles filled by the processor show, away from edges, what the rays see.
// - [threads-agree] The picture is the same, byte for byte, by any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mv/math/transform.h"
#include "ray-cast/cast_objects.h"
#include "ray-cast/textbook_forms.h"
#include "support/demo_run.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int paneSide = 480;  // of the left pane of the demo's own size, which is at the picture's lower left corner
constexpr int top = 540 - paneSide;

int apart(const Pixel& a, const Pixel& b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

}  // namespace

TEST(RayCastFull, like_the_raster) {
    DemoRun run("ray-cast");
    run.set("rows", paneSide).set("threads", 4).set("pixel-x", 0).set("pixel-y", 0);
    for (const char* objects : {"all", "plane", "sphere", "box", "triangle", "polygon", "transformed", "surface",
                                "cylinder", "cone", "disk", "torus"}) {
        static const std::set<std::string_view> inAll{"plane", "sphere", "box", "triangle", "polygon"};
        if (!isLong() && inAll.contains(objects)) continue;
        run.set("objects", objects);
        const Picture raster = run.set("picture-by", "gl").picture();
        const Picture rays = run.set("picture-by", "rays").picture();
        EXPECT_EQ(run.readout("raster-wrong"), 0) << objects;
        EXPECT_LE(run.readout("at-edges"), 5) << objects;
        // Colours: at an edge neighbours differ by more than shading does, 24 of 255 from pixel to pixel
        long wrong = 0, edge = 0;
        for (int y = top + 1; y < 539; ++y) {
            for (int x = 1; x < paneSide - 1; ++x) {
                if (x < 40 && y > 500) continue;  // the mark of the chosen pixel
                bool isEdge = false;
                for (int v = -1; v <= 1; ++v) {
                    for (int u = -1; u <= 1; ++u)
                        isEdge = isEdge || apart(raster.at(x, y), raster.at(x + u, y + v)) > 24;
                }
                edge += isEdge;
                // 128 facets round a sphere: an interpolated normal is off by up to (pi / 128)^2 / 8 rad where it is
                // straight, and three times that at a slant; a value by a rounding: 2 of 255 hold both
                wrong += !isEdge && apart(raster.at(x, y), rays.at(x, y)) > 2;
            }
        }
        EXPECT_EQ(wrong, 0) << objects;
        EXPECT_LE(edge, paneSide * paneSide / 20) << objects;
    }
}

TEST(RayCast, through_the_middle) {
    DemoRun run("ray-cast");
    // The t of the floor at a pixel, beside the point that the scene's own matrices send to that pixel's middle
    run.set("objects", "plane");
    for (const int rows : {16, 33}) {
        run.set("rows", rows);
        for (const double x : {0.3, 0.5, 0.7}) {
            (void)run.set("pixel-x", x).set("pixel-y", 0.4).picture();
            const Scene scene = run.demo().scene(FrameInfo(1, 960, 540));
            const int i = static_cast<int>(x * rows), j = static_cast<int>(0.6 * rows);
            const vec2 middle(2 * (i + 0.5) / rows - 1, 1 - 2 * (j + 0.5) / rows);
            const mat4 worldFromClip = glm::inverse(scene.clipFromWorld());
            const auto at = [&](double depth) {
                const vec4 p = worldFromClip * vec4(middle, depth, 1);
                return vec3(p) / p.w;
            };
            const vec3 eye(glm::inverse(scene.viewFromWorld)[3]), way = glm::normalize(at(1) - at(-1));
            EXPECT_NEAR(run.readout("t"), -eye.y / way.y, 1e-9) << rows << " " << x;  // matrices inverted, 1e-13 each
            const mat3 frame(scene.viewFromWorld);
            EXPECT_NEAR(glm::determinant(frame), 1, 1e-12);
        }
    }
}

TEST(RayCastFull, nearest_first) {
    DemoRun run("ray-cast");
    constexpr int rows = 16, cell = paneSide / rows;
    run.set("rows", rows);
    Random random(22);
    for (int k = 0; k < 20; ++k) {
        const double x = random.number(0.1, 0.9), y = random.number(0.2, 0.7);
        run.set("objects", "all").set("pixel-x", x).set("pixel-y", y);
        // The middle of the chosen pixel, within its mark
        const int column = static_cast<int>(x * rows) * cell + cell / 2,
                  row = top + static_cast<int>((1 - y) * rows) * cell + cell / 2;
        const Pixel together = run.picture().at(column, row);
        Pixel first = run.picture().at(paneSide / 2 + cell / 2, top + cell / 2);  // the sky
        double least = HUGE_VAL;
        int met = 0;
        const double candidates = run.readout("candidates");
        const double t = run.measured("t") ? run.readout("t") : HUGE_VAL;
        for (std::size_t one = 0; one < castTogether; ++one) {
            const Picture alone = run.set("objects", castKindNames.at(one)).picture();
            if (!run.measured("t")) continue;
            ++met;
            if (run.readout("t") >= least) continue;
            least = run.readout("t");
            first = alone.at(column, row);
        }
        EXPECT_EQ(t, least);
        EXPECT_EQ(candidates, met);
        EXPECT_EQ(apart(together, first), 0) << x << " " << y;
    }
}

TEST(RayCastFull, three_planes) {
    DemoRun run("ray-cast");
    run.set("rows", 64);
    for (const char* form : {"textbook", "stable"}) {
        run.set("form", form);
        const Picture implicit = run.set("plane", "implicit").picture();
        EXPECT_EQ(implicit, run.set("plane", "normal").picture()) << form;
        EXPECT_EQ(implicit, run.set("plane", "parametric").picture()) << form;
    }
    Random random(3);
    const vec3 corner(cast::floorCorner), along(cast::floorAlong), up(cast::floorUp), normal = glm::cross(along, up);
    for (int i = 0; i < 1000; ++i) {
        const Ray ray{{random.number(-5, 5), random.number(1, 9), random.number(-5, 5)},
                      {random.number(-1, 1), random.number(-1, -0.1), random.number(-1, 1)}};
        const auto a = intersectPlane(ray, vec4(normal, -glm::dot(normal, corner))),
                   b = intersectPlane(ray, corner, normal);
        const auto c = intersectPlane(ray, corner, along, up);
        ASSERT_TRUE(a && b && c);
        // A few roundings of numbers up to 90
        EXPECT_NEAR(*a, *b, 1e-13);
        EXPECT_NEAR(*a, c->t, 1e-13);
        EXPECT_LT(glm::distance(ray.at(c->t), corner + c->u * along + c->v * up), 1e-12);
    }
}

TEST(RayCastFull, slips_show) {
    DemoRun run("ray-cast");
    run.set("form", "printed").set("rows", 240);
    (void)run.picture();
    EXPECT_GT(run.readout("unlike"), 0.1 * 240 * 240) << "the floor alone is half of the picture";
    for (const char* kind : {"plane", "triangle", "sphere", "box", "polygon", "transformed"}) {
        (void)run.set("objects", kind).set("form", "printed").picture();
        const bool hasSlip = std::string_view(kind) == "plane" || std::string_view(kind) == "triangle";
        EXPECT_EQ(run.readout("unlike") > 0, hasSlip) << kind;
        (void)run.set("form", "textbook").picture();
        EXPECT_EQ(run.readout("unlike"), 0) << kind;
    }
    // The other two forms of the plane are printed as they are
    run.set("objects", "plane").set("form", "printed");
    for (const char* plane : {"normal", "parametric"}) {
        (void)run.set("plane", plane).picture();
        EXPECT_EQ(run.readout("unlike"), 0) << plane;
    }
}

TEST(RayCast, same_t_in_both_spaces) {
    Random random(25);
    const mat4 worldFromObject = cast::worldFromEllipsoid(), objectFromWorld = glm::inverse(worldFromObject);
    int hits = 0, farther = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 eye(random.number(-9, 9), random.number(1, 9), 9);
        const vec3 aim =
            vec3(worldFromObject * vec4(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1), 1));
        const Ray ray{eye, glm::normalize(aim - eye)};
        const auto hit = castAt(CastKind::transformed, 1, ray, {});
        if (!hit) continue;
        ++hits;
        // On the ellipsoid, at t of the world; and the normal is at right angles to the tangents there
        const vec3 at = vec3(objectFromWorld * vec4(ray.at(hit->t), 1));
        EXPECT_NEAR(glm::length(at), 1, 1e-12);
        const vec3 tangent = mat3(worldFromObject) * glm::cross(at, vec3(0.3, 0.5, 0.8));
        EXPECT_NEAR(glm::dot(glm::normalize(hit->normal), tangent), 0, 1e-12);
        // Normalized anew (the slip) t is that of another space
        Ray inside = transformed(ray, objectFromWorld);
        inside.direction = glm::normalize(inside.direction);
        farther += std::abs(intersectSphere(inside, vec3(0), 1.0)->near - hit->t) > 0.1;
    }
    EXPECT_GT(hits, 500);
    EXPECT_GT(farther, hits * 9 / 10);
}

TEST(RayCast, textbook_fails_far) {
    DemoRun run("ray-cast");
    run.set("objects", "sphere").set("precision", "float").set("rows", 64).set("distance", 1e4);
    // The sphere covers about a sixteenth of the picture
    double covered = 0;
    for (const double value : run.set("form", "stable").demo().values()) covered += value < 9;
    (void)run.picture();
    EXPECT_EQ(run.readout("unlike"), 0);
    (void)run.set("form", "textbook").picture();
    EXPECT_GT(run.readout("unlike"), covered / 10);
    (void)run.set("distance", 9).picture();
    EXPECT_EQ(run.readout("unlike"), 0);
}

TEST(RayCastFull, newton_needs_a_start) {
    DemoRun run("ray-cast");
    run.set("objects", "surface").set("rows", 240);
    for (const double distance : {9.0, 100.0, 1000.0}) {
        // Beside the same flag as triangles, whose t is known without Newton: pixels where one has it and the other not
        const auto missed = [&](const char* form) {
            run.set("distance", distance).set("form", form);
            const std::vector<double> rays = run.set("picture-by", "rays").demo().values(),
                                      raster = run.set("picture-by", "raster").demo().values();
            long count = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) count += std::abs(rays[i] - raster[i]) > 0.1;
            return count;
        };
        const long textbook = missed("textbook"), stable = missed("stable");
        EXPECT_GT(textbook, 50) << distance;  // of some 3000 that the flag covers
        EXPECT_LE(stable, textbook / 10) << distance;
    }
    (void)run.set("distance", 9).set("form", "textbook").set("picture-by", "rays").picture();
    EXPECT_FALSE(run.messages().empty());
}

TEST(RayCastFull, threads_agree) {
    DemoRun run("ray-cast");
    for (const char* form : {"textbook", "stable"}) {
        run.set("form", form).set("rows", 61);
        const Picture one = run.set("threads", 1).picture();
        for (const int threads : {2, 3, 7}) {
            // Made anew: another number of rows comes between
            (void)run.set("rows", 60).picture();
            EXPECT_EQ(one, run.set("rows", 61).set("threads", threads).picture()) << form << " " << threads;
        }
    }
}

TEST(RayCastFull, raster_by_hand) {
    DemoRun run("ray-cast");
    run.set("rows", 240);
    for (const char* objects : {"all", "teapot", "sphere", "surface"}) {
        run.set("objects", objects);
        const std::vector<double> rays = run.set("picture-by", "rays").demo().values(),
                                  raster = run.set("picture-by", "raster").demo().values();
        ASSERT_EQ(rays.size(), raster.size());
        long edge = 0, wrong = 0;
        for (int y = 1; y < 239; ++y) {
            for (int x = 1; x < 239; ++x) {
                const std::size_t here = pixelIndex(x, y, 240);
                bool isEdge = false;
                for (int v = -1; v <= 1; ++v) {
                    // A step, or a slope as steep as at an outline
                    for (int u = -1; u <= 1; ++u)
                        isEdge = isEdge || std::abs(rays[here] - rays[pixelIndex(x + u, y + v, 240)]) > 0.15;
                }
                edge += isEdge;
                // 128 facets round a sphere are up to (pi / 128)^2 / 2 within it, a slant makes it ten times as much
                wrong += !isEdge && std::abs(rays[here] - raster[here]) > 0.004;
            }
        }
        EXPECT_EQ(wrong, 0) << objects;
        EXPECT_LE(edge, 240 * 240 / 10) << objects << ": most of the picture is to be judged";
        (void)run.set("picture-by", "raster").picture();
        EXPECT_LE(run.readout("unlike"), edge) << objects << ": nowhere else";
    }
}
