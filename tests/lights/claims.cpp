// The claims of lights, and a test for each.
//
// - [adds] Linear light adds: several lights give the sum of what each gives alone. Numbers that are not encoded do not add
//   on the screen, where encoded ones are expected.
// - [falloff-exponents] A constant, linear or quadratic term alone falls as d^0, d^-1 or d^-2, read from the picture.
// - [ambient-is-everywhere] Ambient light is the same on every surface, whichever way it faces.
// - [directional-is-far] Directional light does not depend on the place, only on the way a surface faces.
// - [behind-lights-nothing] A light behind a surface does not light the surface.
// - [cone] A spot lights nothing outside of its outer cone, as much as a point within the inner one, and its edge has no
//   step where the inner one is smaller.
// - [colours-multiply] Under red light a picture has its red channel and nothing else; red paper under green light is black.
// - [finite] A lamp on a surface, and a spot with one cone, give finite light.
// - [off-costs-nothing] A light that is off, or reaches nothing in view, is not sent, and the picture is the same.
// - [as-in-double] The shader gives what the same formulas give in double.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "lights/lamp_light.h"
#include "mv/geometry/ray_caster.h"
#include "mv/math/transform.h"
#include "mv/paper/audit.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 160, height = 120;
constexpr int floorIs = 0, wallIs = 1;  // of the still life's objects

// The lights, from the first on; the others are off.
void light(DemoRun& run, const std::vector<std::string>& kinds) {
    for (std::size_t i = 0; i < 8; ++i) run.set("light-" + std::to_string(i + 1), i < kinds.size() ? kinds[i] : "off");
}

// The light that arrives at each pixel: what a study compares.
std::vector<float> arriving(DemoRun& run) {
    run.picture();
    return stage().measure(1);
}

// The object that a ray through the middle of each pixel hits; object -1: nothing.
std::vector<SceneHit> seen(DemoRun& run) {
    const Scene scene = run.demo().scene(FrameInfo(1, width, height));
    const RayCaster caster(scene);
    const mat4 worldFromClip = inverse(scene.clipFromWorld());
    const auto at = [&](int i, int j, double z) {
        const vec4 p = worldFromClip * vec4(2 * (i + 0.5) / width - 1, 1 - 2 * (j + 0.5) / height, z, 1);
        return vec3(p) / p.w;
    };
    std::vector<SceneHit> hits;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const vec3 eye = at(i, j, -1);
            hits.push_back(caster.nearest({eye, at(i, j, 1) - eye}).value_or(SceneHit{}));
        }
    }
    return hits;
}

// The pixels whose neighbours show the same object, so that rounding at an outline cannot exchange it.
bool isInside(const std::vector<SceneHit>& hits, std::size_t at) {
    const std::size_t x = at % width, y = at / width;
    if (x == 0 || y == 0 || x + 1 == width || y + 1 == height) return false;
    for (const std::size_t other : {at - 1, at + 1, at - width, at + width}) {
        if (hits[other].object != hits[at].object) return false;
    }
    return true;
}

}  // namespace

TEST(LightsFull, adds) {
    DemoRun run("lights", width, height);
    const std::vector<std::string> all{"ambient", "directional", "point", "spot", "point", "spot", "point", "spot"};
    light(run, all);
    const std::vector<float> together = arriving(run);
    run.set("encode", "off");
    const Picture unencodedTogether = run.picture();
    run.set("encode", "on");
    const Picture encodedTogether = run.picture();
    std::vector<double> sum(together.size(), 0);
    std::vector<int> encodedSum(together.size(), 0), unencodedSum(together.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < all.size(); ++k) run.set("light-" + std::to_string(k + 1), k == i ? all[k] : "off");
        const std::vector<float> alone = arriving(run);
        const Picture encoded = run.picture();
        const Picture unencoded = run.set("encode", "off").picture();
        run.set("encode", "on");
        for (std::size_t p = 0; p < sum.size(); ++p) {
            sum[p] += double(alone[p]);
            const int x = static_cast<int>(p % width), y = static_cast<int>(p / width);
            encodedSum[p] += encoded.at(x, y).green;
            unencodedSum[p] += unencoded.at(x, y).green;
        }
    }
    long compared = 0, encodedApart = 0;
    for (std::size_t p = 0; p < sum.size(); ++p) {
        // Eight additions in float, and the mean of three
        ASSERT_NEAR(double(together[p]), sum[p], 12 * 0x1p-24 * sum[p]) << p;
        const int x = static_cast<int>(p % width), y = static_cast<int>(p / width);
        const int shown = unencodedTogether.at(x, y).green;
        if (shown == 255 || x >= width * 13 / 20) continue;
        encodedApart += std::abs(encodedSum[p] - encodedTogether.at(x, y).green) > 20 ? 1 : 0;
        ++compared;
    }
    EXPECT_GT(compared, 3000);
    // Encoded numbers of single lights say nothing about the sum: the curve is steep where it is dark.
    EXPECT_GT(encodedApart, compared / 2);
}

TEST(Lights, falloff_exponents) {
    DemoRun run("lights", width, height);
    light(run, {"off", "off", "point"});
    const std::vector<SceneHit> hits = seen(run);
    const vec3 lamp(-0.35, 1.3, 0.6);
    const std::vector<std::pair<const char*, double>> terms{{"constant", 0}, {"linear", -1}, {"quadratic", -2}};
    for (const auto& [term, exponent] : terms) {
        for (const auto& [other, ignored] : terms) run.set(other, std::string(other) == term ? 1 : 0);
        const std::vector<float> light = arriving(run);
        // The slope of the logarithms over all of the floor, the cosine at which the light arrives divided out
        double n = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
        for (std::size_t p = 0; p < light.size(); ++p) {
            if (hits[p].object != floorIs || !isInside(hits, p)) continue;
            const double d = glm::distance(lamp, hits[p].point), x = std::log(d);
            const double y = std::log(double(light[p]) * d / lamp.y);
            n += 1, sumX += x, sumY += y, sumXX += x * x, sumXY += x * y;
        }
        ASSERT_GT(n, 1000);
        const double slope = (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
        // A pixel's place is known to a 512th of its width, of some millimetres
        EXPECT_NEAR(slope, exponent, 1e-3) << term;
    }
}

TEST(Lights, ambient_is_everywhere) {
    DemoRun run("lights", width, height);
    light(run, {"ambient"});
    const std::vector<float> light = arriving(run);
    for (const float one : light) ASSERT_EQ(one, light.front());
    EXPECT_NEAR(double(light.front()), 0.06, 1e-6) << "the hue of the first is white";
}

TEST(Lights, directional_is_far) {
    DemoRun run("lights", width, height);
    light(run, {"off", "directional"});
    const std::vector<SceneHit> hits = seen(run);
    const std::vector<float> light = arriving(run);
    for (const int plane : {floorIs, wallIs}) {
        float low = HUGE_VALF, high = 0;
        for (std::size_t p = 0; p < light.size(); ++p) {
            if (hits[p].object != plane || !isInside(hits, p)) continue;
            low = std::min(low, light[p]), high = std::max(high, light[p]);
        }
        EXPECT_GT(low, 0.01F) << plane;
        // The normal is interpolated, and made a unit vector again, in float
        EXPECT_NEAR(double(high / low), 1, 1e-6) << plane;
    }
}

TEST(LightsFull, behind_lights_nothing) {
    DemoRun run("lights", width, height);
    run.set("height", 1.3).set("places", "0,0/0,0/0,0/0,0/0,0/0,0/0,0/0,-1.5");
    for (const char* kind : {"point", "spot", "directional"}) {
        light(run, {kind});
        const std::vector<SceneHit> hits = seen(run);
        const vec3 lamp(0, 1.3, 0);
        const vec3 sun = lamp - vec3(0.35, -1, -0.4);
        const std::vector<float> light = arriving(run);
        long behind = 0, before = 0;
        for (std::size_t p = 0; p < light.size(); ++p) {
            if (hits[p].object < 0 || !isInside(hits, p)) continue;
            const vec3 towards = std::string(kind) == "directional" ? sun : lamp - hits[p].point;
            const double cosine = glm::dot(glm::normalize(towards), hits[p].normal);
            // Smooth normals lean from the triangles' own by up to half of the angle between two: 7 degrees at the pawn
            if (cosine < -0.25) {
                ASSERT_EQ(light[p], 0) << kind << " " << p;
                ++behind;
            }
            before += cosine > 0.25 && light[p] > 0 ? 1 : 0;
        }
        EXPECT_GT(behind, 50) << kind;
        EXPECT_GT(before, 100) << kind;
    }
}

TEST(Lights, cone) {
    DemoRun run("lights", width, height);
    light(run, {"off", "off", "point"});
    const std::vector<SceneHit> hits = seen(run);
    const std::vector<float> point = arriving(run);
    light(run, {"off", "off", "spot"});
    const vec3 lamp(-0.35, 1.3, 0.6), axis = glm::normalize(vec3(1.1, 0, -0.2) - lamp);
    for (const auto& [inner, outer] : std::vector<std::pair<double, double>>{{10, 40}, {25, 25}, {0, 60}}) {
        run.set("inner", inner).set("outer", outer);
        const std::vector<float> spot = arriving(run);
        long within = 0, between = 0, outside = 0;
        for (std::size_t p = 0; p < spot.size(); ++p) {
            if (hits[p].object < 0 || !isInside(hits, p) || point[p] <= 0) continue;
            const double angle = degrees(std::acos(glm::dot(axis, glm::normalize(hits[p].point - lamp))));
            const double part = double(spot[p]) / double(point[p]);
            ASSERT_GE(part, 0);
            ASSERT_LE(part, 1);
            if (angle > outer + 0.1) {
                ASSERT_EQ(part, 0);
                ++outside;
            } else if (angle < inner - 0.1) {
                ASSERT_EQ(part, 1);
                ++within;
            } else if (inner < outer) {
                // The steepest place of 3t^2 - 2t^3 is 1.5: what a tenth of a degree moves
                const double right =
                    spotEdge(std::cos(radians(angle)), std::cos(radians(inner)), std::cos(radians(outer)));
                const double slack = 1.5 * radians(0.1) * std::sin(radians(outer)) /
                                     (std::cos(radians(inner)) - std::cos(radians(outer)));
                ASSERT_NEAR(part, right, slack) << angle;
                ++between;
            }
        }
        EXPECT_GT(outside, 100);
        EXPECT_TRUE(within > 50 || inner == 0);
        EXPECT_TRUE(between > 200 || inner == outer);
    }
}

TEST(Lights, colours_multiply) {
    DemoRun run("lights", width, height);
    const auto scene = [&](const char* light, const char* surface) {
        const Picture picture = run.set("light-color", light).set("surface-color", surface).picture();
        Picture left(width / 2, height);  // without the table, and what is drawn over the scene for people
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < left.width; ++x) left.set(x, y, picture.at(x, y));
        }
        return left;
    };
    light(run, {"ambient", "directional"});
    run.set("height", 3);
    const Picture white = scene("white", "own"), red = scene("red", "own"), green = scene("green", "own"),
                  onRed = scene("green", "red");
    long unlike = 0, drawnOver = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < white.width; ++x) {
            const Pixel is = red.at(x, y);
            // A pixel that is not black there is drawn over the scene for people.
            if (onRed.at(x, y) != Pixel{0, 0, 0}) {
                ++drawnOver;
                continue;
            }
            unlike += is.red != white.at(x, y).red || is.green != 0 || is.blue != 0;
            const Pixel under = green.at(x, y);
            unlike += under.green != white.at(x, y).green || under.red != 0 || under.blue != 0;
        }
    }
    EXPECT_EQ(unlike, 0);
    // The directional light's ball, arrow and number are there, and the cross of the mark: each within a 16th of the height.
    EXPECT_LE(drawnOver, 4 * (height / 16 + 1) * (height / 16 + 1));
}

TEST(Lights, finite) {
    DemoRun run("lights", width, height);
    run.set("height", 0).set("lamp-size", 0.01).set("inner", 30).set("outer", 30).set("power", 100);
    const std::vector<std::vector<std::string>> cases{
        {"point", "point", "point", "point", "point", "point", "point", "point"},
        {"spot", "spot", "spot", "spot", "spot", "spot", "spot", "spot"}};
    for (const auto& kinds : cases) {
        light(run, kinds);
        for (const float one : arriving(run)) {
            ASSERT_TRUE(std::isfinite(one));
            ASSERT_GE(one, 0);
            // None gives more than at its surface, head on
            ASSERT_LE(double(one), 8 * 100 / (0.01 * 0.01));
        }
    }
    light(run, {"spot"});
    run.set("places", "1.1,-0.2/0,0/0,0/0,0/0,0/0,0/0,0/0,0");
    EXPECT_NE(run.refusal().find("--height"), std::string::npos) << "a spot without an axis";
}

TEST(LightsFull, off_costs_nothing) {
    // The audit names a light that is asked for nothing
    const AuditReport report = auditDemo(stage(), findDemo("lights"), {{"ask", "all"}, {"light-4", "off"}}, 1);
    ASSERT_EQ(report.findings.size(), 5U) << auditText(report);
    EXPECT_EQ(report.findings.front().kind, waste::needlessWork);
    EXPECT_EQ(report.findings.front().what, "light 4, which is off");
    const AuditReport far = auditDemo(stage(), findDemo("lights"),
                                      {{"ask", "all"}, {"height", "3"}, {"power", "0.05"}, {"cut-off", "0.1"}}, 1);
    ASSERT_EQ(far.findings.size(), 6U) << auditText(far);
    EXPECT_EQ(far.findings.front().what, "light 3, which reaches nothing");

    DemoRun run("lights", width, height);
    light(run, {"ambient"});
    (void)run.picture();
    EXPECT_EQ(run.readout("lights-sent"), 0);
    light(run, {"ambient", "point", "off", "spot"});
    const Picture two = run.picture();
    EXPECT_EQ(run.readout("lights-sent"), 2);
    const auto work = stage().frameCounters();
    // The places of lights that are off do not matter
    run.set("places", "1,1/-0.75,0.9/1,1/1.7,0.6/1,1/1,1/1,1/1,1");
    EXPECT_EQ(differentPixels(two, run.picture()), 0);
    EXPECT_EQ(stage().frameCounters().draws, work.draws);

    // Asked all the same they change nothing
    const std::vector<float> asked = arriving(run);
    run.set("ask", "all");
    EXPECT_EQ(arriving(run), asked);
    EXPECT_EQ(run.readout("lights-sent"), 7) << "an ambient light is asked of no pixel";
    run.set("ask", "reaching");

    // A lamp 3 above the floor whose light falls below the threshold before it comes to anything
    run.set("height", 3).set("power", 0.05).set("cut-off", 0.1);
    light(run, {"ambient"});
    const std::vector<float> none = arriving(run);
    light(run, {"ambient", "point", "point", "spot"});
    EXPECT_EQ(arriving(run), none);
    EXPECT_EQ(run.readout("lights-sent"), 0);
    run.set("cut-off", 0);
    const std::vector<float> whole = arriving(run);
    EXPECT_NE(whole, none);
    EXPECT_EQ(run.readout("lights-sent"), 3);
    // A shorter reach leaves nothing behind when it is taken off
    run.set("cut-off", 0.005);
    EXPECT_NE(arriving(run), whole);
    EXPECT_EQ(run.readout("lights-sent"), 3);
    run.set("cut-off", 0);
    EXPECT_EQ(arriving(run), whole);
}

TEST(Lights, as_in_double) {
    DemoRun run("lights", width, height);
    run.set("constant", 0.3).set("linear", 0.7).set("quadratic", 1.1).set("inner", 5).set("outer", 50);
    light(run, {"ambient", "off", "point", "spot"});
    const std::vector<SceneHit> hits = seen(run);
    const std::vector<float> light = arriving(run);
    const Falloff falloff{0.3, 0.7, 1.1, 0.05};
    const vec3 point(-0.35, 1.3, 0.6), spot(1.7, 1.3, 0.6), axis = glm::normalize(vec3(1.1, 0, -0.2) - spot);
    long compared = 0;
    for (std::size_t p = 0; p < light.size(); ++p) {
        if (hits[p].object != floorIs && hits[p].object != wallIs) continue;
        if (!isInside(hits, p)) continue;
        const auto lamp = [&](const vec3& place) {
            const vec3 to = place - hits[p].point;
            const double d = glm::length(to);
            return 1.5 * std::max(glm::dot(to / d, hits[p].normal), 0.0) * falloff.at(d);
        };
        const double cosine = glm::dot(axis, glm::normalize(hits[p].point - spot));
        const double edge = spotEdge(cosine, std::cos(radians(5)), std::cos(radians(50)));
        const double right = 0.06 + lamp(point) * (1 + 0.75 + 0.5) / 3 + lamp(spot) * edge * (0.55 + 0.75 + 1) / 3;
        // A pixel's place is known to a 512th of its width, of some millimetres: 1e-4 of light that changes by 1 in 0.1
        ASSERT_NEAR(double(light[p]), right, 2e-4) << p;
        ++compared;
    }
    EXPECT_GT(compared, 5000);
}
