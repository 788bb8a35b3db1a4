// The claims of shadow-floor, and a test for each.
//
// - [cast-by-rays] The picture is what rays show: dark where the way from the floor to the light meets the square.
// - [marker-at-the-light] The yellow ball is where the light of this frame's shadow is, not where the last one's was.
// - [on-one-line] Each ray goes from the light through a corner of the square to the same corner of its shadow.
// - [no-fighting] No pixel of the floor comes through the shadow, which lies 0.0001 above it, at the distances that were tried.
// - [floor-hides-from-below] Seen from below, the floor hides the shadow, which does not shine through.
// - [ends-with-the-floor] With crop on, no shadow lies where there is no floor; without it hangs in the air.
// - [moved-by-keys] The arrow keys move the light by 0.05, and the shadow by a third of that the other way.
// - [no-false-shadow] Light at the square's height, below it, in or below the floor: no shadow, and a sentence says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/demo/demo.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/demo_run.h"
#include "support/shadow_rays.h"

using namespace mv;
using namespace mv::test;

namespace {

const Pixel sky{242, 255, 255}, red{255, 0, 0}, gray{128, 128, 128}, dark{51, 0, 0}, yellow{255, 153, 0};
const SeenColors colors{sky, red, gray, dark};
const mat4 worldFromSquare = translate(0, 0.5, 0);

// The light of a frame by the original's rule, round the point (0, height, 0).
vec3 lightAt(int frame, double height = 2) { return {std::sin(0.02 * frame), height, std::cos(0.02 * frame)}; }

mat4 clipFromWorld(DemoRun& run) { return run.matrix("clipFromView") * run.matrix("viewFromWorld"); }

vec2 windowPoint(DemoRun& run, const Picture& picture, const vec3& point) {
    const vec4 clip = clipFromWorld(run) * vec4(point, 1);
    return {(clip.x / clip.w + 1) / 2 * picture.width, (1 - clip.y / clip.w) / 2 * picture.height};
}

RayComparison againstRays(DemoRun& run, int frame, const vec3& light, bool crop = true) {
    const Picture picture = run.picture(frame);
    const ShadowScene scene{.clipFromWorld = clipFromWorld(run),
                            .worldFromSquare = worldFromSquare,
                            .light = light,
                            .floorHalf = 1.5,
                            .beyondFloor = !crop};
    return compareWithRays(picture, scene, colors, windowPoint(run, picture, light));
}

}  // namespace

TEST(ShadowFloorFull, cast_by_rays) {
    DemoRun run("shadow-floor");
    run.set("rays", "off");
    struct Case {
        int frame;
        double z, spinX, spinY;
    };
    for (const Case c : {Case{1, -4, 0, 0}, {100, -4, -40, 0}, {200, -6, -20, 70}, {250, 3, -10, 200}}) {
        run.set("z-dist", c.z).set("spin-x", c.spinX).set("spin-y", c.spinY);
        const RayComparison result = againstRays(run, c.frame, lightAt(c.frame));
        EXPECT_EQ(result.wrong, 0) << "frame " << c.frame;
        EXPECT_GT(result.shadow, 1000) << "frame " << c.frame;
        EXPECT_GT(result.compared, 600 * 600 * 0.95);  // few edges are passed over
    }
    EXPECT_NEAR(run.readout("shadow-area"), 16.0 / 9, 1e-14);  // (2/1.5)^2, a few roundings
}

TEST(ShadowFloor, marker_at_the_light) {
    DemoRun run("shadow-floor");
    run.set("rays", "off");
    for (const int frame : {1, 90, 250}) {
        const Picture picture = run.picture(frame);
        vec2 sum(0);
        double count = 0;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                if (!sameColor(picture.at(x, y), yellow)) continue;
                sum += vec2(x + 0.5, y + 0.5);
                ++count;
            }
        }
        ASSERT_GT(count, 20);
        const vec2 middle = sum / count;
        // Some 60 pixels: their mean is where the ball is to a fraction of a pixel.
        EXPECT_LT(glm::length(middle - windowPoint(run, picture, lightAt(frame))), 0.3) << frame;
        // The twin, the original's marker: drawn before the light moves, it stands where the last frame's light was.
        const vec3 last = frame == 1 ? vec3(0, 2, 0) : lightAt(frame - 1);
        EXPECT_GT(glm::length(middle - windowPoint(run, picture, last)), 0.7) << frame;
        // And the shadow is this light's: off the diagonal, row i of its matrix is -L_i (0, 1, 0, 0).
        const mat4 m = run.matrix("shadowFromWorld");
        EXPECT_LT(glm::length(vec2(-m[1][0], -m[1][2]) - vec2(lightAt(frame).x, lightAt(frame).z)), 1e-15);
    }
}

TEST(ShadowFloor, on_one_line) {
    DemoRun run("shadow-floor");
    for (const int frame : {1, 60, 200}) {
        const Picture picture = run.set("rays", "on").picture(frame);
        const mat4 clipFromWorld = run.matrix("clipFromView") * run.matrix("viewFromWorld");
        const auto pixelOf = [&](const vec4& point) {
            return pixelFromNdc(ndcFromClip(clipFromWorld * point), picture.width, picture.height);
        };
        const vec2 light = pixelOf({std::sin(0.02 * frame), 2, std::cos(0.02 * frame), 1});
        for (const vec4& corner : {vec4(-0.5, 0.5, 0.5, 1), vec4(0.5, 0.5, 0.5, 1)}) {
            const vec2 through = pixelOf(corner), end = pixelOf(run.matrix("shadowFromWorld") * corner);
            const vec2 along = glm::normalize(end - light), to = through - light;
            EXPECT_NEAR(along.x * to.y - along.y * to.x, 0, 1e-9);
            // Orange between light and corner, where there is nothing else
            for (const double part : {0.2, 0.5, 0.8}) {
                const vec2 at = light + part * to;
                bool found = false;
                for (int up = -1; up <= 1; ++up) {
                    const Pixel p = picture.at(int(at.x), picture.height - 1 - int(at.y) + up);
                    found |= p.red > 220 && p.blue < 180;
                }
                EXPECT_TRUE(found) << "frame " << frame << " at " << at.x << ", " << at.y;
            }
        }
    }
}

TEST(ShadowFloorFull, no_fighting) {
    DemoRun run("shadow-floor");
    run.set("rays", "off");
    for (const double z : {-10, -4, 4, 10}) {
        for (const double spinX : {0.0, z < 0 ? -80.0 : 80.0}) {  // along the floor, and straight down on it
            run.set("z-dist", z).set("spin-x", spinX);
            const RayComparison result = againstRays(run, 30, lightAt(30));
            EXPECT_EQ(result.wrong, 0) << "z " << z << ", spin " << spinX;
            EXPECT_GT(result.shadow, 200);
        }
    }
}

TEST(ShadowFloor, floor_hides_from_below) {
    DemoRun run("shadow-floor");
    run.set("rays", "off");
    for (const double spinX : {20, 40, 80}) {
        for (const double z : {-10, -4}) {
            const Picture picture = run.set("z-dist", z).set("spin-x", spinX).picture(30);
            EXPECT_EQ(countPixels(picture, dark), 0) << spinX;
            EXPECT_GT(countPixels(picture, gray), 1000) << spinX;
        }
    }
    EXPECT_GT(countPixels(run.set("spin-x", -40).picture(30), dark), 1000);  // from above it is there
}

TEST(ShadowFloorFull, ends_with_the_floor) {
    DemoRun run("shadow-floor");
    run.set("rays", "off");
    run.set("light-x", -1).set("light-height", 1).set("spin-y", 60);
    const vec3 light = lightAt(20, 1) + vec3(-1, 0, 0);
    for (const bool crop : {true, false}) {
        const RayComparison result = againstRays(run.set("crop", crop ? "on" : "off"), 20, light, crop);
        EXPECT_EQ(result.wrong, 0);
        EXPECT_GT(result.shadow, 5000);
    }
    // The two rules give different pictures here, so that either could fail.
    EXPECT_GT(againstRays(run.set("crop", "on"), 20, light, false).wrong, 1000);
    // The level square's shadow is 2 p - L on each axis, cut at 1.5.
    double area = 1;
    for (const double l : {light.x, light.z}) area *= std::min(1.5, 1 - l) - std::max(-1.5, -1 - l);
    EXPECT_NEAR(run.readout("on-floor"), area, 1e-14);  // a few roundings of numbers up to 4
    EXPECT_NEAR(run.readout("shadow-area"), 4, 1e-14);
    // A low light throws the whole shadow beside the floor: nothing is seen of it, and a sentence says where it is.
    run.set("crop", "on").set("light-x", 0).set("light-height", 0.6).picture();
    EXPECT_EQ(run.readout("on-floor"), 0);
    ASSERT_EQ(run.messages().size(), 1U);
    EXPECT_EQ(run.messages().front().rfind("The shadow falls beside the floor", 0), 0U);
    run.set("crop", "off").picture();
    EXPECT_TRUE(run.messages().empty());
}

TEST(ShadowFloor, moved_by_keys) {
    DemoRun run("shadow-floor");
    run.set("rays", "off");
    run.picture();
    const auto shadowOfMiddle = [&] {
        const vec4 shadow = run.matrix("shadowFromWorld") * vec4(0, 0.5, 0, 1);
        return vec3(shadow) / shadow.w;
    };
    struct Case {
        Key key;
        vec3 step;
    };
    for (const Case& c : {Case{Key::left, {-0.05, 0, 0}},
                          {Key::right, {0.05, 0, 0}},
                          {Key::up, {0, 0, -0.05}},
                          {Key::down, {0, 0, 0.05}}}) {
        const vec3 before = shadowOfMiddle();
        EXPECT_TRUE(run.demo().press(c.key));
        run.picture();
        // 4/3 p - 1/3 L: a third of the light's step, the other way. A few roundings.
        EXPECT_LT(glm::length(shadowOfMiddle() - before + c.step / 3.0), 1e-14);
    }
    // Without the circle the light stands where the keys put it.
    run.set("circle", "off").set("light-x", 0.25).set("light-z", -0.5).picture(77);
    EXPECT_EQ(run.matrix("shadowFromWorld")[1][0], -0.25);
    EXPECT_EQ(run.matrix("shadowFromWorld")[1][2], 0.5);
}

TEST(ShadowFloorFull, no_false_shadow) {
    DemoRun run("shadow-floor");
    run.set("rays", "off");
    run.set("crop", "off").set("spin-x", -20);
    for (const auto& [height, sentence] : {
             std::pair{0.4, "The light is below the square: it casts no shadow on the floor."},        // X11
             std::pair{0.5, "The square is as high as the light: its shadow would lie at infinity."},  // X12
             std::pair{0.0, "The light lies in the floor: there is no shadow."},                       // X14
             std::pair{-1.0, "The light is below the floor: no shadow falls on its upper side."},
         }) {
        run.set("light-height", height);
        for (const int frame : {1, 80, 157, 240}) {
            const Picture picture = run.picture(frame);
            EXPECT_EQ(countPixels(picture, dark), 0) << height << ", frame " << frame;
            EXPECT_GT(countPixels(picture, gray), 1000);
            EXPECT_EQ(run.onlyMessage(), sentence);
            EXPECT_FALSE(run.measured("shadow-area"));
        }
    }
    // The twin of X11: unchecked, the anti-shadow of a light at 0.4 is behind the eye, and there its w is positive
    // again, w' times the negative depth, so that GL draws it in the picture.
    run.set("light-height", 0.4).set("spin-x", 0).picture(157);
    const vec3 light = lightAt(157, 0.4);
    mat4 textbook(1);
    textbook[3][3] = 0;
    textbook[1][3] = -1 / light.y;
    const vec4 anti = translate(light) * textbook * translate(-light) * vec4(0, 0.5, 0, 1);
    EXPECT_LT(anti.w, 0);
    EXPECT_GT((run.matrix("viewFromWorld") * (anti / anti.w)).z, 0);  // behind the eye
    const vec4 clip = clipFromWorld(run) * anti;
    EXPECT_GT(clip.w, 0);
    // Just above the square's height the shadow is some 1e9 wide, and covers what the rays say.
    const double near = 0.500000001;
    EXPECT_EQ(
        againstRays(run.set("light-height", near).set("spin-x", -20).set("crop", "on"), 80, lightAt(80, near)).wrong,
        0);
}
