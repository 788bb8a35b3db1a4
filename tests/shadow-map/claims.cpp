// The claims of shadow-map, and a test for each.
//
// - [cast-by-rays] With a fine map the shadows are those that rays find, to a pixel at their edges.
// - [error-is-one-over-resolution] Without a filter the misjudged part of the picture falls as 1/resolution.
// - [acne-without-bias] Without a bias the surfaces in the map shade themselves, in stripes; slope-bias 1 ends that on flat
//   surfaces that slope; surfaces that face the light need the least constant bias, too.
// - [light-leaks-with-bias] With back faces in the map, a bias lets light in at the foot of a caster.
// - [floor-left-out-needs-no-bias] A floor that is not in the map cannot be shaded falsely, and needs no bias.
// - [back-faces-need-no-bias] With back faces in the map, no surface that faces the light shades itself.
// - [thin-casters-are-missed] Where a caster is thinner than a texel, parts of its shadow are missing: of a cord's, most in a
//   coarse map and few in a fine one.
// - [coarse-casters-throw-polygons] A ball of n sides throws a polygon, whose missing area falls as 1/n^2.
// - [map-is-kept] The map is not drawn again while light and casters rest, and the picture is the same.
// - [frustum-holds-the-map] The white lines are the edges of the map's view; a fitted view is tight round the casters.
// - [slide-projector] The slide's colour at a point is the one where the map would look that point up, and what is in shadow gets none.
// - [reverse-projection] Behind the projector nothing is thrown; without the question for w the line through the projector has one colour
//   before it and behind it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/geometry/light_view.h"
#include "mv/geometry/ray_caster.h"
#include "mv/study/study.h"
#include "shadow-map/shadow-map.h"
#include "shared/lit_reference.h"
#include "shared/scenes.h"
#include "support/demo_run.h"
#include "support/softpipe.h"

using namespace mv;
using namespace mv::test;

namespace {

// 40 % of these pixels and more are floor; some seconds of rays at most, also under a sanitizer.
constexpr int width = 240, height = 180;

struct Place {
    std::string scene;
    Scene (*make)(double aspect);
    vec3 light, target;
};
const Place cube{"cube-on-plane", cubeOnPlane, {-2.2, 3.6, 1.4}, {0, 0, 0}};
const Place still{"still-life", stillLife, {-3.4, 4.2, 2.6}, {0.4, 0.5, -0.8}};

std::vector<KnobSetting> settingsOf(const Place& place) {
    const auto at = [](const std::string& name, const vec3& p) {
        return std::vector<KnobSetting>{
            {name + "-x", numberText(p.x)}, {name + "-y", numberText(p.y)}, {name + "-z", numberText(p.z)}};
    };
    std::vector<KnobSetting> settings{{"scene", place.scene}, {"fov", "60"}, {"window-width", "1"},
                                      {"window-height", "1"}, {"bias", "0"}, {"show-map", "off"},
                                      {"show-frustum", "off"}};
    for (const auto& more : {at("light", place.light), at("target", place.target)})
        settings.insert(settings.end(), more.begin(), more.end());
    return settings;
}

void strike(DemoRun& run, const Place& place) {
    for (const KnobSetting& setting : settingsOf(place)) run.set(setting.name, setting.text);
}

// The demo's picture against rays cast here, in pixels, away from where the rays change from a pixel to the next.
struct Judged {
    long dark = 0, lit = 0, n = 0;  // falsely so; compared
    double darkPart() const { return double(dark) / double(n); }
    double litPart() const { return double(lit) / double(n); }
    double wrongPart() const { return darkPart() + litPart(); }
    double drawnWhereLit = 0;  // mean of what is drawn where it should be 1
};

// `only` is an object of the scene; -1: all.
Judged judge(DemoRun& run, const Place& place, const vec4& light, int only = -1) {
    run.picture();  // so that the matrices are those of these settings
    Scene scene = place.make(double(width) / height);
    scene.viewFromWorld = run.matrix("viewFromWorld");
    scene.lights = {{.position = light}};
    const Reference right = litReference(scene, FrameInfo(1, width, height), {}, {});
    const std::vector<float> drawn = stage().measure(1);
    Judged result;
    double sum = 0, litPixels = 0;
    for (int y = 1; y + 1 < height; ++y) {
        for (int x = 1; x + 1 < width; ++x) {
            const std::size_t here = pixelIndex(x, y, width);
            bool atEdge = false;
            for (int i = 0; i < 9; ++i) {
                const std::size_t there = pixelIndex(x + i % 3 - 1, y + i / 3 - 1, width);
                atEdge |= right.regions[here] != right.regions[there] || right.values[here] != right.values[there];
            }
            if (atEdge || right.regions[here] < 0 || (only >= 0 && right.regions[here] != only)) continue;
            EXPECT_GE(drawn[here], 0) << x << ", " << y;
            ++result.n;
            sum += right.values[here] * drawn[here];
            litPixels += right.values[here];
            result.dark += right.values[here] > 0.5 && drawn[here] <= 0.5F ? 1 : 0;
            result.lit += right.values[here] < 0.5 && drawn[here] > 0.5F ? 1 : 0;
        }
    }
    EXPECT_GT(result.n, 1000);
    result.drawnWhereLit = sum / litPixels;
    return result;
}

Judged judge(DemoRun& run, const Place& place, int only = -1) { return judge(run, place, vec4(place.light, 1), only); }

// The point where the line of sight through the middle of a pixel meets the floor y = 0.
vec3 onFloor(DemoRun& run, int x, int y) {
    const mat4 worldFromClip = glm::inverse(run.matrix("clipFromView") * run.matrix("viewFromWorld"));
    const double clipX = 2 * (x + 0.5) / width - 1, clipY = 1 - 2 * (y + 0.5) / height;
    const vec4 near = worldFromClip * vec4(clipX, clipY, -1, 1), far = worldFromClip * vec4(clipX, clipY, 1, 1);
    const vec3 a = vec3(near) / near.w, b = vec3(far) / far.w;
    return a + a.y / (a.y - b.y) * (b - a);
}

}  // namespace

TEST(ShadowMapFull, cast_by_rays) {
    DemoRun run("shadow-map", width, height);
    for (const Place& place : {cube, still}) {
        strike(run, place);
        run.set("resolution", "2048").set("slope-bias", 3).set("spin-x", 0).set("spin-y", 0);
        for (const char* filter : {"none", "hardware", "pcf3"}) {
            SCOPED_TRACE(place.scene + ", " + filter);
            const Judged judged = judge(run.set("filter", filter), place);
            // At a body's own shadow line a texel still reaches round: some pixels in ten thousand of the still life.
            EXPECT_LT(judged.wrongPart(), 1e-3);
        }
        run.set("spin-x", 15).set("spin-y", 40);
        EXPECT_LT(judge(run, place).wrongPart(), 1e-3);
        run.set("spin-x", 0).set("spin-y", 0).set("projection", "orthographic");
        run.set("window-width", 5).set("window-height", 5);
        const Judged parallel = judge(run, place, vec4(place.light - place.target, 0));
        EXPECT_LT(parallel.wrongPart(), 1e-3);
        run.set("projection", "spot");
        // Broken on purpose, it shows: without bias, by one look, since the mean of several is about a half on a plane, which rounding
        // takes for dark or for lit; and with the light's place moved a little for GL alone.
        EXPECT_GT(judge(run.set("filter", "none").set("slope-bias", 0), place).darkPart(), 0.1);
        run.set("slope-bias", 3).set("light-x", place.light.x + 0.5);
        EXPECT_GT(judge(run, place).wrongPart(), 1e-3);
    }
}

TEST(ShadowMapFull, error_is_one_over_resolution) {
    DemoRun run("shadow-map");
    Study study = *stage().info().study;
    study.width = 320, study.height = 240;
    study.scenes = {study.scenes[0]};
    study.lines = {study.lines[0]};
    ASSERT_EQ(study.lines[0].method, "1 tap");
    // Larger texels than the study's own, so that there are some hundred wrong pixels to count in so small a picture. (Up to 74
    // degrees the floor is nearer than the map's end, where a driver that pushes corners, as softpipe does, pushes less.)
    study.lines[0].settings.push_back({"fov", "72"});
    study.lines[0].values = {"64", "128", "256", "512", "1024"};
    const StudyRun result = runStudy(stage(), study, {.timed = false});
    for (const StudyRow& row : result.rows) ASSERT_TRUE(row.ok()) << row.parameter << ": " << row.status;
    EXPECT_GT(result.rows[0].all.fraction, 16 * result.rows[4].all.fraction / 2);
    const auto slope = errorSlope(result, study.scenes[0].name, "1 tap");
    ASSERT_TRUE(slope);
    EXPECT_NEAR(*slope, -1, 0.1);
}

TEST(ShadowMapFull, acne_without_bias) {
    DemoRun run("shadow-map", width, height);
    strike(run, cube);
    run.set("slope-bias", 0);
    const Judged bare = judge(run, cube);
    // Half of the points of a texel's footprint are deeper than its middle, and all of them by rounding or not.
    EXPECT_GT(bare.darkPart(), 0.3);
    EXPECT_LT(bare.darkPart(), 0.7);
    EXPECT_NEAR(run.readout("falsely-dark"), 100 * bare.darkPart(), 8);  // a coarser grid over the same stripes
    EXPECT_GT(run.readout("pixels-asked"), 5000);
    // The floor slopes along one axis of this map: half a texel's slope is what it needs, and 1 is enough for any.
    const Judged less = judge(run.set("slope-bias", 0.25), cube);
    EXPECT_GT(less.darkPart(), 0.01);
    EXPECT_LT(less.darkPart(), bare.darkPart());
    EXPECT_EQ(judge(run.set("slope-bias", 1), cube).dark, 0);
    EXPECT_LT(run.readout("falsely-dark"), 0.2);  // steps of the shadow's edge
    // From a light low over the floor to one straight above it, whose steepness differs a hundredfold (table E, X17)
    for (const vec3& light : {vec3(-9.5, 1, 0), vec3(-6, 1.5, 2), vec3(-3, 3, 3), vec3(0, 5, 0)}) {
        const Place place{cube.scene, cube.make, light, cube.target};
        strike(run, place);
        // A face towards the light has no slope, and so no bias by it: whether its depth is the map's is for rounding to say, and
        // another driver says so in some pixels. The least constant bias decides it.
        if (light.x == 0) run.set("bias", 1e-4);
        const long dark = judge(run, place, 0).dark;
        if (!clampsOffsetAtCorners()) {  // under a light that is low the floor reaches the map's end
            EXPECT_EQ(dark, 0) << light.y;
        }
    }
    strike(run, cube);
    // A wider filter reaches farther down the slope, and needs a bias of its width: n + 1 for n x n looks of 2 x 2.
    EXPECT_LT(judge(run.set("filter", "pcf5"), cube).drawnWhereLit, 0.9);
    EXPECT_GT(judge(run.set("slope-bias", 6), cube).drawnWhereLit, 0.99);
}

TEST(ShadowMap, light_leaks_with_bias) {
    DemoRun run("shadow-map", width, height);
    strike(run, cube);
    run.set("resolution", "1024").set("map-faces", "back").set("slope-bias", 0);
    run.set("spin-y", 300);  // from where the foot is seen
    EXPECT_LT(judge(run, cube, 0).litPart(), 2e-4);
    const std::vector<float> close = stage().measure(1);
    const Judged leaking = judge(run.set("bias", 0.01), cube, 0);
    EXPECT_GT(leaking.litPart(), 0.001);
    EXPECT_GT(run.readout("falsely-lit"), 0.1);
    const std::vector<float> far = stage().measure(1);
    // Where the floor has lost its shadow it is near the cube, about the origin; where it has kept it, farther away.
    double lostSum = 0, keptSum = 0;
    long lost = 0, kept = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = pixelIndex(x, y, width);
            if (close[i] != 0) continue;
            const double away = glm::length(onFloor(run, x, y));
            (far[i] > 0 ? lostSum : keptSum) += away;
            ++(far[i] > 0 ? lost : kept);
        }
    }
    ASSERT_GT(lost, 20);
    ASSERT_GT(kept, 20);
    EXPECT_LT(lostSum / double(lost), 0.8 * keptSum / double(kept));
    // Front faces are as much nearer to the light as the body is thick: the same bias does nothing.
    EXPECT_LT(judge(run.set("map-faces", "front"), cube, 0).litPart(), 2e-4);
}

TEST(ShadowMap, floor_left_out_needs_no_bias) {
    DemoRun run("shadow-map", width, height);
    strike(run, cube);
    run.set("slope-bias", 0).set("receiver", "on");
    EXPECT_GT(judge(run, cube, 0).darkPart(), 0.3);
    const long with = stage().frameCounters().triangles;
    const Judged without = judge(run.set("receiver", "off"), cube, 0);
    // The rest are steps of texels along the edge, a pixel or two wide.
    EXPECT_LT(without.wrongPart(), 2e-3);
    EXPECT_LE(stage().frameCounters().triangles, with);
}

TEST(ShadowMapFull, back_faces_need_no_bias) {
    DemoRun run("shadow-map", width, height);
    for (const Place& place : {cube, still}) {
        strike(run, place);
        run.set("slope-bias", 0).set("resolution", "2048").set("map-faces", "front");
        EXPECT_GT(judge(run, place).darkPart(), 0.1);
        // Not quite nothing: where a body thins out towards its own shadow line, its back is within a texel of its front.
        EXPECT_LT(judge(run.set("map-faces", "back"), place).darkPart(), 1e-3);
        EXPECT_GT(judge(run.set("map-faces", "both"), place).darkPart(), 0.1);
    }
}

TEST(ShadowMapFull, thin_casters_are_missed) {
    DemoRun run("shadow-map", 600, 600);
    run.preset("overhead");
    const FrameInfo frame(1, 600, 600);
    const Reference right = litReference(stage().demo().scene(frame), frame, {}, {});
    // In the right half of the picture, where the ball's shadow is not: of the cords' shadows, the part that is drawn lit
    const auto missed = [&](const char* resolution) {
        run.set("resolution", resolution).picture();
        const std::vector<float> drawn = stage().measure(1);
        double shadow = 0, lit = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (i % 600 < 300 || right.regions[i] < 0 || right.values[i] > 0.5) continue;
            ++shadow;
            lit += drawn[i] > 0.5F ? 1 : 0;
        }
        EXPECT_GT(shadow, 500);
        return lit / shadow;
    };
    EXPECT_GT(missed("128"), 0.6);
    EXPECT_GT(missed("512"), 0.3);
    EXPECT_LT(missed("4096"), 0.15);
}

TEST(ShadowMapFull, coarse_casters_throw_polygons) {
    DemoRun run("shadow-map", 600, 600);
    run.preset("overhead");
    run.set("resolution", "4096").set("cord", 0.001);
    const auto missing = [&](const char* sides) {
        run.set("sides", sides).picture();
        EXPECT_LT(run.readout("falsely-dark"), 0.1) << sides << ": its corners lie on the ball";
        return run.readout("falsely-lit");
    };
    // Some 300 of the grid's 9000 points are in the ball's shadow.
    const double coarse = missing("6"), finer = missing("12"), fine = missing("48");
    EXPECT_NEAR(coarse / finer, 4, 2);
    EXPECT_GT(coarse, 20 * std::max(fine, 0.001));
}

TEST(ShadowMapFull, map_is_kept) {
    DemoRun run("shadow-map", width, height);
    const auto passes = [&] {
        stage().draw(1);
        return stage().frameCounters().passes;
    };
    EXPECT_EQ(passes(), 2);
    EXPECT_EQ(passes(), 1);
    run.set("spin-y", 30).set("filter", "pcf3").set("bias", 0.01).set("show-map", "off");
    EXPECT_EQ(passes(), 1);  // the camera and the lookup do not matter to it
    for (const auto& [knob, value] : {std::pair{"light-x", "2"},
                                      {"target-z", "3"},
                                      {"fov", "100"},
                                      {"resolution", "256"},
                                      {"slope-bias", "2"},
                                      {"map-faces", "back"},
                                      {"receiver", "off"},
                                      {"scene", "overhead"},
                                      {"sides", "8"},
                                      {"cord", "0.02"},
                                      {"scene", "still-life"},
                                      {"frustum", "fitted"},
                                      {"projection", "orthographic"}}) {
        run.set(knob, value);
        EXPECT_EQ(passes(), 2) << knob;
        EXPECT_EQ(passes(), 1) << knob;
        const Picture kept = stage().picture();
        run.set("keep", "off");
        EXPECT_EQ(passes(), 2);
        EXPECT_EQ(passes(), 2);
        EXPECT_EQ(stage().picture(), kept) << knob;
        run.set("keep", "on");
        EXPECT_EQ(passes(), 1);
    }
    // The map of a picture that keeps nothing is not taken for what was kept before it.
    const Picture kept = run.picture();
    EXPECT_NE(run.set("keep", "off").set("light-y", 4).picture(), kept);
    EXPECT_EQ(run.set("keep", "on").set("light-y", 4.8).picture(), kept);
}

TEST(ShadowMap, frustum_holds_the_map) {
    DemoRun run("shadow-map");
    run.set("show-map", "off");
    for (const char* fit : {"set", "fitted"}) {
        const Picture with = run.set("frustum", fit).set("show-frustum", "on").picture();
        const Picture without = run.set("show-frustum", "off").picture();
        const mat4 clipFromMap = run.matrix("clipFromView") * run.matrix("viewFromWorld") *
                                 glm::inverse(glm::inverse(mapFromClip()) * run.matrix("mapFromWorld"));
        // Points along the twelve edges of the map's own cube, where they are in the picture: there it has changed.
        int inPicture = 0, shown = 0;
        for (int edge = 0; edge < 12; ++edge) {
            for (double t = -0.95; t < 1; t += 0.05) {
                vec4 p(edge & 1 ? 1 : -1, edge & 2 ? 1 : -1, 0, 1);
                p = edge < 4 ? vec4(p.x, p.y, t, 1) : edge < 8 ? vec4(p.x, t, p.y, 1) : vec4(t, p.x, p.y, 1);
                const vec4 clip = clipFromMap * p;
                if (std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) >= 0.99 * clip.w) continue;
                ++inPicture;
                const int x = int((clip.x / clip.w + 1) / 2 * with.width);
                const int y = int((1 - clip.y / clip.w) / 2 * with.height);
                bool changed = false;
                for (int v = y - 1; v <= y + 1; ++v) {
                    for (int u = x - 1; u <= x + 1; ++u) changed |= with.at(u, v) != without.at(u, v);
                }
                shown += changed ? 1 : 0;
            }
        }
        EXPECT_GT(inPicture, 60) << fit;
        EXPECT_GT(shown, inPicture / 2) << fit;  // the others are behind floor and bodies
    }
    // Fitted, all that casts is on the map and nearly fills it: the default margin of 2 % a side, and nothing more.
    vec3 low(1), high(0);
    for (const vec3& p : casterPoints(sphereAndCube(1))) {
        const vec4 onMap = run.matrix("mapFromWorld") * vec4(p, 1);
        low = glm::min(low, vec3(onMap) / onMap.w);
        high = glm::max(high, vec3(onMap) / onMap.w);
    }
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(low[axis], 0.02 / 1.04, 1e-9);
        EXPECT_NEAR(high[axis], 1.02 / 1.04, 1e-9);
    }
    // In the cube: no perspective holds what is all round it.
    EXPECT_EQ(run.set("light-y", 1).set("light-x", 3).set("light-z", 0.5).refusal(),
              "--light-y: must keep the light clear of what casts, for a fitted frustum, 1");
    run.set("frustum", "set").set("target-x", 3).set("target-y", 1).set("target-z", 0.5);
    EXPECT_EQ(run.refusal(), "--light-x: the light must not be at its target, 3");
    // Straight above its target the light has a roll by agreement, and by the same one where it is off by a last place.
    run.set("light-x", 2.5).set("light-y", 4.8).set("light-z", 3.5);
    const Picture above = run.set("target-x", 2.5).set("target-z", 3.5).picture();
    for (const char* beside : {"2.5000000000000004", "2.4999999999999996"}) {
        EXPECT_EQ(run.set("light-x", std::string(beside)).refusal(), "");
        EXPECT_EQ(run.picture(), above) << beside;
    }
}

namespace {

// The floor's points that a picture shows, away from all else: its pixels, and their places in the world.
std::vector<std::pair<Pixel, vec3>> floorOf(const Picture& picture, const Scene& scene) {
    const RayCaster rays(scene);
    const mat4 worldFromClip = glm::inverse(scene.clipFromWorld());
    const vec3 eye(glm::inverse(scene.viewFromWorld)[3]);
    std::vector<std::pair<Pixel, vec3>> result;
    for (int y = 2; y < picture.height; y += 7) {
        for (int x = 2; x < picture.width; x += 7) {
            const vec4 far =
                worldFromClip * vec4(2 * (x + 0.5) / picture.width - 1, 1 - 2 * (y + 0.5) / picture.height, 1, 1);
            const auto hit = rays.nearest({eye, vec3(far) / far.w - eye});
            if (hit && hit->object == 0 && !rays.inShadow(*hit, scene.lights[0].position))
                result.emplace_back(picture.at(x, y), hit->point);
        }
    }
    return result;
}

// The slide's colour where this matrix takes the point, whatever its w; none beyond the slide, and beside a stripe's edge.
std::optional<Pixel> slideAt(const mat4& mapFromWorld, const vec3& point) {
    const vec4 on = mapFromWorld * vec4(point, 1);
    const double u = on.x / on.w, v = on.y / on.w;
    if (!(u > 0.02 && u < 0.98 && v > 0.02 && v < 0.98)) return {};
    const Picture slide = shadow_map::slidePicture();
    const auto at = [&](double right, double up) {
        return slide.at(int((u + right) * slide.width), slide.height - 1 - int((v + up) * slide.height));
    };
    for (const double off : {-0.02, 0.02})
        if (at(off, 0) != at(0, 0) || at(0, off) != at(0, 0)) return {};
    return at(0, 0);
}

struct Thrown {
    long right = 0, wrong = 0;
};
// Whether each channel is above ambient light where the slide lets it through, and is ambient light where not.
Thrown judgeSlide(DemoRun& run, bool behind) {
    const Picture picture = run.picture();
    const mat4 mapFromWorld = run.matrix("mapFromWorld");
    Scene scene = run.demo().scene(FrameInfo(1, picture.width, picture.height));
    const vec3 ambient = 0.3 * 255.0 * scene.objects[0].color;
    Thrown result;
    for (const auto& [pixel, point] : floorOf(picture, scene)) {
        if (((mapFromWorld * vec4(point, 1)).w < 0) != behind) continue;
        const auto slide = slideAt(mapFromWorld, point);
        if (!slide) continue;
        const auto isThrown = [](int seen, double least) { return seen > least + 2; };
        const bool agrees = isThrown(pixel.red, ambient.r) == (slide->red > 0) &&
                            isThrown(pixel.green, ambient.g) == (slide->green > 0) &&
                            isThrown(pixel.blue, ambient.b) == (slide->blue > 0);
        ++(agrees ? result.right : result.wrong);
    }
    return result;
}

}  // namespace

TEST(ShadowMap, slide_projector) {
    DemoRun run("shadow-map");
    run.preset("slide-behind").set("slide", "thrown").set("show-frustum", "off").set("show-map", "off");
    const Thrown thrown = judgeSlide(run, false);
    EXPECT_GT(thrown.right, 150);
    // Beside the edges of shadows and stripes a point may fall to either side
    EXPECT_LE(thrown.wrong, thrown.right / 50);
    // In shadow there is ambient light alone, at most 0.3 of the lightest colour there, 0.93
    run.preset("slide-projector").set("show-frustum", "off").set("show-map", "off").set("filter", "none");
    const Picture picture = run.picture();
    const std::vector<float> lit = stage().measure(1);
    long dark = 0, bright = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const Pixel p = picture.at(x, y);
            const int most = std::max({p.red, p.green, p.blue});
            if (lit[pixelIndex(x, y, picture.width)] == 0) {
                ASSERT_LE(most, 0.3 * 0.93 * 255 + 1) << x << ", " << y;
                ++dark;
            } else {
                bright += most > 0.3 * 0.93 * 255 + 1;
            }
        }
    }
    EXPECT_GT(dark, 5000);
    EXPECT_GT(bright, 50000);
}

TEST(ShadowMap, reverse_projection) {
    DemoRun run("shadow-map");
    run.preset("slide-behind").set("show-frustum", "off").set("show-map", "off");
    const Thrown reversed = judgeSlide(run, true);
    EXPECT_GT(reversed.right, 300);
    EXPECT_LE(reversed.wrong, reversed.right / 50);
    const Thrown asked = (run.set("slide", "thrown"), judgeSlide(run, true));
    EXPECT_EQ(asked.right, 0);
    EXPECT_GT(asked.wrong, 300);
}
