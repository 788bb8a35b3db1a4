// The claims of path, and a test for each.
//
// - [forward-is-velocity] The car looks where it goes, by every rule, and its frame is orthonormal and right-handed.
// - [on-its-side] On a flat bend up by the acceleration lays the car on its side; minus gravity it leans by atan(v^2/(rg)).
// - [flips-at-inflections] On the flat figure of eight the acceleration's up turns over at both inflections; that of the
//   banked and of the minimizing frame nowhere.
// - [no-turn-about-the-path] The minimizing frame does not turn about the path. On a flat curve it closes; in space it does
//   not, and spread over the lap its closing angle is gone.
// - [equal-ways] Equal times are equal ways by arc length, but not by the parameter.
// - [chase-keeps-car] The chase camera keeps the car in the same place of its picture.
// - [shortest-turn] Slerp takes the shortest turn at constant speed, nlerp the same at another, three angles neither.
// - [gimbal-lock] With the nose straight up, yaw and roll are one turn: other angles give the same pose, but another way.
// - [axes-told-apart] Forward, up and right have colours that are told apart by eyes without cones of long or of middle waves, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/math/transform.h"
#include "path/lap.h"
#include "path/track.h"
#include "support/color_vision.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// The place of the car of the last picture, and its axes.
struct Car {
    vec3 position, forward, up, right;
};
Car carAt(DemoRun& run, int frame) {
    (void)run.picture(frame);
    const mat4 worldFromCar = run.matrix("worldFromCar");
    return {vec3(worldFromCar[3]), -vec3(worldFromCar[2]), vec3(worldFromCar[1]), vec3(worldFromCar[0])};
}

// Of curvature, by the curve itself.
double smallestRadius(Track track, Through through) {
    const Curve<vec3>& curve = trackPath(track, through).curve;
    double smallest = HUGE_VAL;
    for (int i = 0; i < 4000; ++i) {
        const CurvePoint<vec3> at = curve.at(i / 4000.0);
        const double speed = glm::length(at.velocity);
        smallest = std::min(smallest, speed * speed * speed / glm::length(glm::cross(at.velocity, at.acceleration)));
    }
    return smallest;
}

double largestEntry(const mat4& m) {
    double largest = 0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(m[column][row]));
    }
    return largest;
}

const std::array<const char*, 4> rules{"fixed", "acceleration", "banking", "minimizing"};

// The angle of the turn from one pose to the other, by the trace of its matrix: none of the library's quaternions.
mat4 poseOf(double yaw, double pitch, double roll) { return rotateY(yaw) * rotateX(pitch) * rotateZ(roll); }
double angleOf(const mat4& from, const mat4& to) {
    const mat4 turn = glm::transpose(from) * to;
    return degrees(std::acos(std::clamp((turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2, -1.0, 1.0)));
}

struct Poses {
    std::array<double, 3> from, to;
};
const std::array<Poses, 4> pairs{{{{0, 40, 0}, {180, 55, 180}},
                                  {{-60, 10, 0}, {100, 70, 60}},
                                  {{10, -80, 30}, {50, 20, -100}},
                                  {{0, 0, 0}, {90, 90, 0}}}};
void setPoses(DemoRun& run, const Poses& poses) {
    const std::array<std::string, 3> angles{"-yaw", "-pitch", "-roll"};
    for (std::size_t i = 0; i < 3; ++i) run.set("from" + angles[i], poses.from[i]).set("to" + angles[i], poses.to[i]);
}

}  // namespace

TEST(PathFull, forward_is_velocity) {
    DemoRun run("path", 240, 140);
    EXPECT_GT(smallestRadius(Track::park, Through::spline), 4);
    EXPECT_GT(smallestRadius(Track::knot, Through::spline), 4);
    for (const char* track : {"park", "knot"}) {
        for (const char* rule : rules) {
            for (const char* pace : {"way", "parameter"}) {
                SCOPED_TRACE(std::string(track) + ", " + rule + ", " + pace);
                run.set("track", track).set("up", rule).set("pace", pace);
                for (int frame = 20; frame < 1000; frame += 97) {
                    const Car car = carAt(run, frame);
                    // From the place before to the place after, half a metre apart or so, on a curve of radius 4 and more:
                    // the direction differs by the square of a quarter, over 6 radii squared, 7e-4.
                    const vec3 gone = carAt(run, frame + 1).position - carAt(run, frame - 1).position;
                    EXPECT_LT(glm::length(glm::normalize(gone) - car.forward), 1e-3);
                    const mat3 axes(car.right, car.up, -car.forward);
                    EXPECT_LT(largestEntry(mat4(glm::transpose(axes) * axes) - mat4(1)), 1e-14);
                    EXPECT_GT(glm::determinant(axes), 0);
                }
            }
        }
    }
}

TEST(Path, on_its_side) {
    DemoRun run("path", 240, 140);
    run.set("track", "ring");
    for (const double speed : {5.0, 14.0, 30.0}) {
        run.set("speed", speed);
        for (const int frame : {0, 33, 200}) {
            SCOPED_TRACE(std::to_string(speed) + " m/s, frame " + std::to_string(frame));
            // The ring goes to the left, so both lean to the left. The ring is flat to the last place.
            (void)run.set("up", "acceleration").picture(frame);
            EXPECT_NEAR(run.readout("lean"), -90, 1e-9);
            // A spline through 64 keys of a circle has its curvature to h^2/12 = 8e-4; the angle changes by at most half
            // of that, 4e-4 rad.
            (void)run.set("up", "banking").picture(frame);
            EXPECT_NEAR(run.readout("lean"), -degrees(std::atan(speed * speed / (20 * 9.81))), degrees(4.1e-4));
            (void)run.set("up", "fixed").picture(frame);
            EXPECT_NEAR(run.readout("lean"), 0, 1e-9);
        }
    }
}

TEST(PathFull, flips_at_inflections) {
    DemoRun run("path", 240, 140);
    run.set("track", "eight");
    for (const int steps : {120, 361, 3000}) {  // the inflections are samples, or between two
        for (const char* rule : rules) {
            (void)run.set("up", rule).set("steps", steps).picture();
            EXPECT_EQ(run.readout("flips"), rule == std::string("acceleration") ? 2 : 0) << rule << ", " << steps;
        }
    }
    // Whirls of the park are counted at any number of samples: twice in its loop, where the path is nearly upright.
    for (const int steps : {120, 361, 3000}) {
        run.set("track", "park").set("steps", steps);
        (void)run.set("up", "fixed").picture();
        EXPECT_EQ(run.readout("flips"), 2) << steps;
        (void)run.set("up", "acceleration").picture();
        EXPECT_EQ(run.readout("flips"), 3) << steps;
    }
    // Too fast on the hill up points below the level, and goes over from there.
    (void)run.set("up", "banking").set("steps", 360).picture();
    EXPECT_EQ(run.readout("flips"), 0);
    (void)run.set("speed", 24).set("start", 60).picture();
    EXPECT_LT(run.readout("lean"), -90);
    EXPECT_GT(run.readout("flips"), 0);
}

TEST(Path, no_turn_about_the_path) {
    DemoRun run("path", 240, 140);
    run.set("up", "minimizing");
    // In a plane the frame keeps to it: what is left are roundings, over steps of 0.5 m.
    for (const char* track : {"ring", "eight"}) {
        (void)run.set("track", track).picture();
        EXPECT_LT(run.readout("most-turn"), 1e-10) << track;
        EXPECT_NEAR(run.readout("closing-angle"), 0, 1e-10) << track;
    }
    // In space the turn is measured against the least turn from sample to sample, from which double reflection differs by
    // the cube of a step: by the square for a metre.
    std::vector<double> turns;
    for (const int steps : {500, 1000, 2000}) {
        (void)run.set("track", "knot").set("steps", steps).picture();
        turns.push_back(run.readout("most-turn"));
    }
    EXPECT_LT(turns[2], 1e-2);
    for (const std::size_t i : {1U, 2U}) EXPECT_NEAR(std::log2(turns[i - 1] / turns[i]), 2, 0.2);
    // The frame does not close there, unless its closing angle is spread: evenly but for that difference, and for that between
    // ways and chords, steps of 0.14 m on radii of 4 m and more: 5e-5 of it.
    for (const char* track : {"knot", "park"}) {
        (void)run.set("track", track).set("spread", "off").picture();
        const double off = run.readout("closing-angle"), before = run.readout("most-turn");
        EXPECT_GT(std::abs(off), 5) << track;
        (void)run.set("spread", "on").picture();
        EXPECT_NEAR(run.readout("closing-angle"), 0, 1e-9) << track;
        const double even = std::abs(off) / run.readout("length");
        EXPECT_NEAR(run.readout("most-turn"), even, before + 5e-5 * even) << track;
    }
}

TEST(PathFull, equal_ways) {
    DemoRun run("path", 240, 140);
    for (const char* curve : {"spline", "catmull-rom"}) {
        const auto steps = [&](const char* pace) {
            run.set("curve", curve).set("pace", pace);
            std::vector<double> lengths;
            for (int frame = 0; frame < 1180; frame += 59) {
                const vec3 before = carAt(run, frame).position;
                lengths.push_back(glm::distance(before, carAt(run, frame + 1).position));
            }
            return lengths;
        };
        // A chord is shorter than its arc by the cube of that over 24 radii squared, and the next term is 1/1000 of it.
        const double way = 14 / 60.0;
        const double radius =
            smallestRadius(Track::park, curve == std::string("spline") ? Through::spline : Through::catmullRom);
        for (const double length : steps("way")) {
            EXPECT_LT(length, way + 1e-12) << curve;
            EXPECT_GT(length, way - 1.01 * way * way * way / (24 * radius * radius)) << curve;
        }
        EXPECT_NEAR(run.readout("car-speed"), 14, 1e-12);
        const std::vector<double> uneven = steps("parameter");
        EXPECT_GT(*std::ranges::max_element(uneven), 1.8 * *std::ranges::min_element(uneven)) << curve;
    }
    // The rules for the length agree where their pieces are many: chords to the square of a piece.
    (void)run.set("curve", "spline").set("pieces", 64).set("length-by", "chords").picture();
    EXPECT_NEAR(run.readout("length-off"), 0, 2e-3);
    EXPECT_LT(run.readout("length-off"), 0) << "chords are short cuts";
    (void)run.set("length-by", "gauss").set("pieces", 16).picture();
    EXPECT_NEAR(run.readout("length-off"), 0, 1e-9);
}

TEST(Path, chase_keeps_car) {
    DemoRun run("path", 240, 140);
    for (const char* rule : rules) {
        (void)run.set("up", rule).picture(0);
        const mat4 first = run.matrix("chaseFromWorld") * run.matrix("worldFromCar");
        EXPECT_NEAR(first[3].x, 0, 1e-12) << "in the middle from left to right";
        for (const int frame : {100, 555, 900}) {
            (void)run.picture(frame);
            const mat4 now = run.matrix("chaseFromWorld") * run.matrix("worldFromCar");
            // Places up to 50 m, some roundings of 1.1e-16 of them
            EXPECT_LT(largestEntry(now - first), 1e-12) << rule << ", " << frame;
        }
    }
}

TEST(Path, shortest_turn) {
    DemoRun run("path", 240, 140);
    run.set("scene", "poses");
    for (const Poses& poses : pairs) {
        setPoses(run, poses);
        (void)run.picture();
        const double angle =
            angleOf(poseOf(poses.from[0], poses.from[1], poses.from[2]), poseOf(poses.to[0], poses.to[1], poses.to[2]));
        SCOPED_TRACE(angle);
        // acos of the trace has its worst relative error near 0 and 180 degrees, where none of these are
        EXPECT_NEAR(run.readout("turned-slerp"), angle, 1e-9);
        EXPECT_NEAR(run.readout("turned-nlerp"), angle, 1e-9);
        EXPECT_GT(run.readout("turned-angles"), 1.02 * angle);
        EXPECT_NEAR(run.readout("uneven-slerp"), 1, 1e-9);
        // Nlerp turns at 1/|q|^2, q being the point of the chord: 1/cos^2 of a quarter of the angle in the middle by the
        // ends. Each speed is a mean over 1/180, which at the ends is larger by half of that times its slope.
        const double ratio = 1 / std::pow(std::cos(radians(angle / 4)), 2);
        EXPECT_NEAR(run.readout("uneven-nlerp"), ratio, ratio * 2 * (1 - std::cos(radians(angle / 2))) / 360 + 1e-4);
    }
}

TEST(Path, gimbal_lock) {
    DemoRun run("path", 240, 140);
    run.set("scene", "poses").set("start", 100);
    const auto turnsWith = [&](double yaw, double roll) {
        setPoses(run, {{-30, 0, 0}, {yaw, 90, roll}});
        (void)run.picture(0);
        EXPECT_NEAR(run.readout("axes-apart"), 0, 1e-12);
        EXPECT_EQ(run.messages().size(), 1U);
        return std::array{run.readout("turned-angles"), run.readout("turned-slerp")};
    };
    // Yaw less roll is all that counts there.
    const auto byYaw = turnsWith(60, 0), byRoll = turnsWith(0, -60), byBoth = turnsWith(90, 30);
    EXPECT_NEAR(byYaw[1], byRoll[1], 1e-9);
    EXPECT_NEAR(byYaw[1], byBoth[1], 1e-9);
    EXPECT_GT(std::abs(byYaw[0] - byRoll[0]), 1);
    EXPECT_GT(std::abs(byYaw[0] - byBoth[0]), 1);
    EXPECT_NE(run.messages().at(0).find("gimbal lock at pose to"), std::string::npos);
    // A degree before, yaw and roll are two turns, and nothing is said.
    setPoses(run, {{-30, 0, 0}, {60, 89, 0}});
    (void)run.picture(0);
    const double degreeBefore = run.readout("turned-slerp");
    EXPECT_TRUE(run.messages().empty());
    EXPECT_NEAR(run.readout("axes-apart"), 1, 1e-12);
    setPoses(run, {{-30, 0, 0}, {0, 89, -60}});
    (void)run.picture(0);
    EXPECT_GT(std::abs(run.readout("turned-slerp") - degreeBefore), 0.1);
}

TEST(Path, axes_told_apart) {
    EXPECT_GT(leastDifference(std::array{forwardColor, upColor, rightColor}), toldApart);
    EXPECT_LT(leastDifference(std::array{vec4(0.80, 0.10, 0.10, 1), vec4(0.05, 0.55, 0.10, 1)}), toldApart)
        << "a red and a green of one lightness";
}
