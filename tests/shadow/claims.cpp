// The claims of shadow, and a test for each; rows X11 to X14 of docs/stability.md.
//
// - [cast-by-rays] The picture is what rays show: dark where the way from the plane to the light meets the square.
// - [textbook-matrix] The matrix is the course's T(light) M T(-light) but for a factor; +1/y_l is on the wrong side.
// - [on-the-ray] Each corner's shadow lies on the plane y = 0, on the line through light and corner.
// - [above-the-light] A square above the light casts no shadow; without the check one appears opposite.
// - [at-the-lights-height] A square at the light's height casts no shadow, and no number becomes NaN.
// - [below-the-floor] A square below the plane casts no shadow; without the check its false shadow has w > 0 and is drawn.
// - [light-not-above] With the light in or below the plane there is no shadow, and a sentence says so.
// - [circles-by-index] In frame n the light is at angle 0.1 n, computed and not summed up.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/math/transform.h"
#include "support/demo_run.h"
#include "support/shadow_rays.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr Pixel paper{255, 255, 255}, squareColor{255, 0, 0}, black{0, 0, 0};
constexpr SeenColors seenColors{paper, squareColor, paper, black};

vec3 lightOfFrame(int frame, double height) { return {std::sin(0.1 * frame), height, std::cos(0.1 * frame)}; }

vec3 divided(const vec4& p) { return vec3(p) / p.w; }

// The course's matrix for a light at this height: row 4 is (0, -1/y, 0, 0).
mat4 textbook(const vec3& light, double sign = -1) {
    mat4 m(1);
    m[3][3] = 0;
    m[1][3] = sign / light.y;
    return translate(light) * m * translate(-light);
}

RayComparison againstRays(DemoRun& run, int frame, double height) {
    const Picture picture = run.picture(frame);
    const ShadowScene scene{.clipFromWorld = run.matrix("clipFromView") * run.matrix("viewFromWorld"),
                            .worldFromSquare = run.matrix("worldFromModel"),
                            .light = lightOfFrame(frame, height)};
    return compareWithRays(picture, scene, seenColors);
}

// The middle of the square's shadow without any check, in the picture.
vec3 uncheckedShadow(DemoRun& run, const vec3& light) {
    const vec4 middle = run.matrix("worldFromModel") * vec4(0, 0, 0, 1);
    return vec3(run.matrix("clipFromView") * run.matrix("viewFromWorld") * vec4(divided(textbook(light) * middle), 1));
}

}  // namespace

TEST(ShadowFull, cast_by_rays) {
    DemoRun run("shadow");
    run.set("rays", "off");
    struct Case {
        int frame;
        double light, square, tilt;
    };
    for (const Case c : {Case{1, 2, 0.5, 0}, {17, 2, 0.5, 0}, {24, 0.9, 0.5, -30}, {50, 4, 1.2, -30}, {3, 1, 0, 150}}) {
        run.set("light-height", c.light).set("square-height", c.square).set("tilt", c.tilt);
        const RayComparison result = againstRays(run, c.frame, c.light);
        EXPECT_EQ(result.wrong, 0) << "frame " << c.frame << ", tilt " << c.tilt;
        EXPECT_GT(result.shadow, 500) << "frame " << c.frame << ", tilt " << c.tilt;
        EXPECT_GT(result.compared, 512 * 512 * 0.9);  // the edges that are passed over are few
    }
}

TEST(Shadow, textbook_matrix) {
    DemoRun run("shadow");
    run.set("rays", "off");
    for (const int frame : {1, 16, 47}) {
        run.set("light-height", 2).picture(frame);
        const vec3 light = lightOfFrame(frame, 2);
        const mat4 ours = run.matrix("shadowFromWorld"), course = textbook(light);
        // A homogeneous matrix means the same times any factor; ours is y_l times the course's.
        const mat4 difference = ours - light.y * course;
        for (int column = 0; column < 4; ++column) {
            EXPECT_LT(glm::length(difference[column]), 1e-15);  // a rounding or two of numbers up to 2
        }
        // E5: with +1/y_l the point lands above the light, on the other side of it.
        const vec4 corner(0.5, 0.5, -0.5, 1);
        const vec3 right = divided(ours * corner), wrong = divided(textbook(light, +1) * corner);
        EXPECT_LT(glm::dot(right - light, wrong - light), 0);
        EXPECT_NEAR(wrong.y, 2 * light.y, 1e-14);
    }
}

TEST(Shadow, on_the_ray) {
    DemoRun run("shadow");
    run.set("rays", "off");
    for (const double tilt : {0, 25, -75}) {
        run.set("tilt", tilt).picture(9);
        const vec3 light = lightOfFrame(9, 2);
        for (const vec3 corner : {vec3(-0.5, 0, 0.5), vec3(0.5, 0, 0.5), vec3(0.5, 0, -0.5), vec3(-0.5, 0, -0.5)}) {
            const vec3 caster(run.matrix("worldFromModel") * vec4(corner, 1));
            const vec3 shadow = divided(run.matrix("shadowFromWorld") * vec4(caster, 1));
            // Coordinates of up to 3, a few roundings each.
            EXPECT_NEAR(shadow.y, 0, 1e-14);
            EXPECT_LT(glm::length(glm::cross(shadow - light, caster - light)), 1e-14);
            EXPECT_GT(glm::dot(shadow - light, caster - light), 0);
        }
    }
    // The size that follows for the level square: as the distances from the light, 2/1.5, squared.
    run.set("tilt", 0).picture();
    EXPECT_NEAR(run.readout("shadow-area"), 16.0 / 9, 1e-14);
    EXPECT_EQ(run.readout("least-w"), 1.5);
}

TEST(Shadow, above_the_light) {
    DemoRun run("shadow");
    run.set("rays", "off");
    const Picture picture = run.set("light-height", 0.3).picture(40);
    EXPECT_EQ(countPixels(picture, black), 0);
    EXPECT_GT(countPixels(picture, squareColor), 1000);
    EXPECT_EQ(run.onlyMessage(), "The light is below the square: it casts no shadow on the floor.");
    EXPECT_NEAR(run.readout("least-w"), -0.2, 1e-15);
    EXPECT_FALSE(run.measured("shadow-area"));
    // The twin: divided without a look at w, the anti-shadow lies in the picture.
    const vec3 anti = uncheckedShadow(run, lightOfFrame(40, 0.3));
    EXPECT_LT(std::abs(anti.x), 1);
    EXPECT_LT(std::abs(anti.y), 1);

    // A square that reaches above the light: only its lower part casts.
    for (const int frame : {1, 40}) {
        const RayComparison part = againstRays(run.set("light-height", 0.6).set("tilt", 50), frame, 0.6);
        EXPECT_EQ(part.wrong, 0);
        EXPECT_GT(part.shadow, 1000);
        EXPECT_EQ(run.onlyMessage(), "Only the part of the square below the light casts a shadow.");
        EXPECT_FALSE(run.measured("shadow-area"));  // it reaches to infinity
    }
}

TEST(Shadow, at_the_lights_height) {
    DemoRun run("shadow");
    run.set("rays", "off");
    const Picture picture = run.set("light-height", 0.5).picture(7);
    EXPECT_EQ(countPixels(picture, black), 0);
    EXPECT_EQ(run.onlyMessage(), "The square is as high as the light: its shadow would lie at infinity.");
    EXPECT_EQ(run.readout("least-w"), 0);
    // The twin: 0 in every w, so the division gives no number.
    const vec4 corner = textbook(lightOfFrame(7, 0.5)) * vec4(0.5, 0.5, 0.5, 1);
    EXPECT_EQ(corner.w, 0);
    EXPECT_FALSE(std::isfinite(divided(corner).x));
    // As near as a setting can be: a shadow some 1e9 wide, and still what the rays show.
    const RayComparison near = againstRays(run.set("light-height", 0.500000001), 7, 0.500000001);
    EXPECT_EQ(near.wrong, 0);
}

TEST(Shadow, below_the_floor) {
    DemoRun run("shadow");
    run.set("rays", "off");
    const Picture picture = run.set("square-height", -0.4).picture(40);
    EXPECT_EQ(countPixels(picture, black), 0);
    EXPECT_EQ(run.onlyMessage(), "The square is not above the floor: no shadow of it falls there.");
    // The twin: its w is positive, so nothing but the height tells.
    const vec3 light = lightOfFrame(40, 2);
    EXPECT_GT((textbook(light) * vec4(0, -0.4, 0, 1)).w, 0);
    const vec3 shadow = uncheckedShadow(run, light);
    EXPECT_LT(std::abs(shadow.x), 1);
    EXPECT_LT(std::abs(shadow.y), 1);

    // A square that goes through the plane: only its upper part casts.
    const RayComparison part = againstRays(run.set("square-height", 0.2).set("tilt", 60), 40, 2);
    EXPECT_EQ(part.wrong, 0);
    EXPECT_GT(part.shadow, 5000);
    EXPECT_EQ(run.onlyMessage(), "Only the part of the square above the floor casts a shadow.");
    EXPECT_LT(run.readout("shadow-area"), 1.1);
    // In the plane there is nothing to fight over: the square, and no shadow.
    EXPECT_EQ(countPixels(run.set("square-height", 0).set("tilt", 0).picture(), black), 0);
}

TEST(Shadow, light_not_above) {
    DemoRun run("shadow");
    run.set("rays", "off");
    for (const double height : {0.0, 1e-7, -1e-7, -1.0}) {
        const Picture picture = run.set("light-height", height).picture(40);
        EXPECT_EQ(countPixels(picture, black), 0) << height;
        EXPECT_GT(countPixels(picture, squareColor), 1000);
        EXPECT_EQ(run.onlyMessage(), height == -1 ? "The light is below the floor: no shadow falls on its upper side."
                                                  : "The light lies in the floor: there is no shadow.");
        EXPECT_FALSE(run.measured("shadow-area"));
    }
    // The twins: in the plane the entry -1/y is no number; below it a shadow appears in the picture, with w > 0.
    EXPECT_FALSE(std::isfinite(textbook(lightOfFrame(40, 0))[1][3]));
    const vec3 light = lightOfFrame(40, -1);
    EXPECT_GT((textbook(light) * vec4(0, 0.5, 0, 1)).w, 0);
    EXPECT_LT(std::abs(uncheckedShadow(run, light).x), 1);
    EXPECT_LT(std::abs(uncheckedShadow(run, light).y), 1);
    EXPECT_TRUE(run.set("light-height", 2).picture().width > 0 && run.messages().empty());
}

TEST(Shadow, circles_by_index) {
    DemoRun run("shadow");
    run.set("rays", "off");
    for (const int frame : {0, 1, 63, 100000}) {
        run.picture(frame);
        // Off the diagonal, row i of the matrix is -L_i (0, 1, 0, 0).
        const mat4 m = run.matrix("shadowFromWorld");
        EXPECT_NEAR(-m[1][0], std::sin(0.1 * frame), 1e-15);
        EXPECT_NEAR(-m[1][2], std::cos(0.1 * frame), 1e-15);
    }
    // The twin: 100000 steps of 0.1 added up in float, as a shader's clock would, have lost the place.
    float sum = 0;
    for (int i = 0; i < 100000; ++i) sum += 0.1F;
    EXPECT_GT(std::abs(static_cast<double>(sum) - 10000), 1);
}
