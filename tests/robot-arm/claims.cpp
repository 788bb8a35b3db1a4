// The claims of robot-arm, and a test for each.
//
// - [product] The product of the matrices on the way to a part places it; two links end where the slide's formula says.
// - [by-rates] The angles of a frame are those of the start plus its number times the rates: no sum, no drift.
// - [solutions] Two links have none, one, two or infinitely many solutions, each named, and each drawn ends at the target.
// - [all-arrive] All methods bring the two links, and the arm, within a millimetre of targets that are well within reach.
// - [never-farther] No iteration of any method leaves the end farther from its goal than it was.
// - [nearest] For targets out of reach, damped least squares ends within a thousandth of the reach of the nearest point.
// - [straight-stalls] A straight arm with its target on its lower link does not move, by any method. Bent by a degree it
//   arrives, but for coordinate descent, which makes it straight again and stays.
// - [limits-hold] No joint of the arm leaves its limits; without them it reaches targets that it does not reach with them.
// - [person-by-splines] Each joint of the person goes through its angle in each pose at the pose's time, by a spline without a jump
//   of its speed, straight with one.
// - [through-each-other] Between two poses in which no parts are in each other the forearm passes through the trunk, which is found
//   and said; with poses between them it goes around. Walking, no part is in another.
// - [foot-slides] With angles between right poses the standing foot slides: less with more poses, but always some.
// - [foot-stands] With inverse kinematics the foot stands: in closed form to rounding, by iteration to its tolerance.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <string>
#include <vector>

#include "mv/math/transform.h"
#include "mv/math/types.h"
#include "support/demo_run.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::array<const char*, 3> iterative{"ccd", "transpose", "dls"};

// The number of a readout in a frame of these settings.
double read(DemoRun& run, const std::string& readout, int frame = 1) {
    (void)run.picture(frame);
    return run.readout(readout);
}

// The same as the first column of a turn about z: its angle in degrees.
double angleAboutZ(const mat4& parentFromPart) {
    return degrees(std::atan2(parentFromPart[0][1], parentFromPart[0][0]));
}

DemoRun& targetAt(DemoRun& run, const vec3& at) {
    return run.set("target-x", at.x).set("target-y", at.y).set("target-z", at.z);
}

}  // namespace

TEST(RobotArm, product) {
    DemoRun run("robot-arm", 240, 140);
    for (const auto& [theta1, theta2] : {std::pair{60.0, 250.0}, {0.0, 0.0}, {-200.0, 17.0}, {359.0, -359.0}}) {
        run.set("rate-1", 0).set("rate-2", 0).set("theta-1", theta1).set("theta-2", theta2);
        (void)run.picture();
        // The slide's formula; sines and cosines of angles up to 720 degrees, some roundings of a reach of 2 m
        const double a = radians(theta1), b = radians(theta1 + theta2);
        EXPECT_NEAR(run.readout("end-x"), 1.2 * std::cos(a) + 0.8 * std::cos(b), 1e-14);
        EXPECT_NEAR(run.readout("end-y"), 1.2 * std::sin(a) + 0.8 * std::sin(b), 1e-14);
        const mat4 product = run.matrix("worldFromUpper") * run.matrix("upperFromLower");
        EXPECT_EQ(product, run.matrix("worldFromLower"));
        const vec4 end = product * vec4(0.8, 0, 0, 1);
        EXPECT_EQ(vec2(end), vec2(run.readout("end-x"), run.readout("end-y")));
    }
    // In space, and along one branch of a tree that has two
    run.set("scene", "arm").set("method", "dls");
    (void)run.picture();
    EXPECT_EQ(run.matrix("worldFromTurret") * run.matrix("turretFromUpper") * run.matrix("upperFromLower") *
                  run.matrix("lowerFromHand"),
              run.matrix("worldFromHand"));
    EXPECT_EQ(run.matrix("upperFromLower")[3], vec4(1.2, 0, 0, 1)) << "it stands where the upper arm ends";
    run.set("scene", "walker").set("method", "closed");
    (void)run.picture(30);
    EXPECT_EQ(run.matrix("worldFromBody") * run.matrix("bodyFromThigh") * run.matrix("thighFromShank"),
              run.matrix("worldFromShank"));
}

TEST(RobotArm, by_rates) {
    DemoRun run("robot-arm", 240, 140);
    for (const int frame : {0, 1, 300, 3600, 20000}) {
        (void)run.picture(frame);
        // 20000 * 1.2 is rounded to half of its last place, 2e-12 degrees; so is the sum with 60
        const double a = radians(std::fmod(60 + frame * 1.2, 360)), b = radians(std::fmod(250 - frame * 0.1, 360));
        EXPECT_NEAR(run.readout("end-x"), 1.2 * std::cos(a) + 0.8 * std::cos(a + b), 2e-13) << frame;
        EXPECT_NEAR(run.readout("end-y"), 1.2 * std::sin(a) + 0.8 * std::sin(a + b), 2e-13) << frame;
    }
    // Whole turns of both: 300 frames of 1.2 degrees, 3600 of 0.1.
    const double x = read(run, "end-x", 3600), y = run.readout("end-y");
    EXPECT_NEAR(read(run, "end-x", 7200), x, 2e-13);
    EXPECT_NEAR(run.readout("end-y"), y, 2e-13);
    EXPECT_GT(std::abs(read(run, "end-x", 3900) - x), 0.01) << "the second has turned by 30 degrees";
}

TEST(RobotArm, solutions) {
    DemoRun run("robot-arm", 240, 140);
    run.set("method", "closed");
    struct Case {
        vec2 target;
        double solutions, away;
    };
    for (const auto& [target, solutions, away] : std::vector<Case>{{{1.1, 0.7}, 2, 0},
                                                                   {{-0.3, -0.5}, 2, 0},
                                                                   {{2, 0}, 1, 0},
                                                                   {{0, -2}, 1, 0},
                                                                   {{2.4, 1.8}, 0, 1},
                                                                   {{0.1, 0}, 0, 0.3},
                                                                   {{0, 0}, 0, 0.4}}) {
        (void)targetAt(run, vec3(target, 0)).picture();
        EXPECT_EQ(run.readout("solutions"), solutions) << target.x << ", " << target.y;
        EXPECT_NEAR(run.readout("to-target"), away, 4e-15);  // some roundings of a reach of 2
    }
    // One: 1.2 - 0.8 is not 0.4 in binary, so the hole's edge is where the difference is.
    (void)run.set("upper", 1.5).set("lower", 0.5).set("target-x", -1).set("target-y", 0).picture();
    EXPECT_EQ(run.readout("solutions"), 1);
    // Infinitely many: none is told, and what is shown is one of them.
    run.preset("any-way");
    EXPECT_NEAR(read(run, "to-target"), 0, 4e-16);
    EXPECT_FALSE(run.measured("solutions"));
    // A picture of its own for each: the words and the poses differ.
    const Picture many = run.picture(), two = run.set("target-x", 0.01).picture();
    EXPECT_EQ(run.readout("solutions"), 2);
    EXPECT_GT(differentPixels(many, two), 100);
}

TEST(RobotArm, all_arrive) {
    DemoRun run("robot-arm", 240, 140);
    run.set("iterations", 64).set("matrices", "off");
    for (const std::string scene : {"two-links", "arm"}) {
        run.set("scene", scene);
        for (const vec3& target : {vec3(1.1, 0.7, 0.6), vec3(0.5, 1, 0.7), vec3(0.8, 0.3, 0.4), vec3(0.6, 0.4, -0.8)}) {
            targetAt(run, target);
            for (const char* method : iterative) {
                // A millimetre: of Jacobian transpose 64 iterations are few.
                EXPECT_LT(read(run.set("method", method), "to-target"), 1e-3) << scene << ", " << method;
            }
            // Tolerance 1e-9 of the reach, 2.4
            EXPECT_LT(read(run, "to-target"), 2.4e-9) << scene;
            if (scene == "arm") continue;
            EXPECT_LT(read(run.set("method", "closed"), "to-target"), 4e-15);
        }
    }
}

TEST(RobotArmFull, never_farther) {
    DemoRun run("robot-arm", 240, 140);
    run.set("matrices", "off");
    for (const std::string scene : {"two-links", "arm"}) {
        for (const char* method : iterative) {
            for (const char* beyond : {"0", "1"}) {
                run.set("scene", scene).set("method", method).set("beyond", beyond);
                double last = HUGE_VAL;
                for (const int most : {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64}) {
                    const double now = read(run.set("iterations", most), "residual");
                    EXPECT_LE(now, last) << scene << ", " << method << ", " << most;
                    last = now;
                    EXPECT_LE(run.readout("iterations-used"), most);
                }
                EXPECT_LT(last, 0.1) << "and it comes near";
            }
        }
    }
}

TEST(RobotArm, nearest) {
    DemoRun run("robot-arm", 240, 140);
    run.set("method", "dls").set("iterations", 64).set("limits", "off").set("matrices", "off");
    for (const auto& [scene, reach] : {std::pair{"two-links", 2.0}, {"arm", 2.4}}) {
        run.set("scene", scene);
        for (const vec3& target : {vec3(1.1, 0.7, 0.6), vec3(-1, 0.2, 0.3), vec3(0.4, 2, -0.5)}) {
            targetAt(run, target);
            for (const double beyond : {1e-3, 0.1, 1.0, 100.0}) {
                const double farther = read(run.set("beyond", beyond), "to-target") - beyond;
                EXPECT_GE(farther, -1e-13) << "nobody reaches beyond the reach";
                // The projection's thousandth, and the tolerance
                EXPECT_LE(farther, (0.001 + 1e-9) * reach) << scene << ", " << beyond;
            }
        }
        run.set("beyond", 0);
    }
}

TEST(RobotArm, straight_stalls) {
    DemoRun run("robot-arm", 240, 140);
    run.preset("stalled").set("iterations", 64);
    for (const char* method : iterative) {
        run.set("method", method).set("theta-2", 0);
        EXPECT_NEAR(read(run, "to-target"), 0.4, 1e-15) << method;
        EXPECT_EQ(run.readout("iterations-used"), 0) << method;
        for (const double bend : {-1.0, 1.0}) {
            const double bent = read(run.set("theta-2", bend), "to-target");
            if (std::string(method) == "ccd")
                EXPECT_NEAR(bent, 0.4, 1e-15) << "its first turn is the one that makes the arm straight again";
            else
                EXPECT_LT(bent, 2e-9) << method;
        }
    }
}

TEST(RobotArmFull, limits_hold) {
    DemoRun run("robot-arm", 240, 140);
    run.set("scene", "arm").set("iterations", 64);
    Random random(36);
    int atLimit = 0, farther = 0;
    for (int i = 0; i < 40; ++i) {
        targetAt(run, random.point(2));
        for (const char* method : iterative) {
            run.set("method", method).set("limits", "on");
            const double limited = read(run, "to-target");
            const mat4 turret = run.matrix("worldFromTurret");
            const double turn = degrees(std::atan2(-turret[0][2], turret[0][0]));
            const double shoulder = angleAboutZ(run.matrix("turretFromUpper"));
            const double elbow = angleAboutZ(run.matrix("upperFromLower"));
            const double wrist = angleAboutZ(run.matrix("lowerFromHand"));
            const double slack = 1e-12;  // of angles that come back through sine, cosine and arc tangent
            EXPECT_LE(std::abs(turn), 160 + slack);
            EXPECT_GE(shoulder, -slack);
            EXPECT_GE(elbow, -150 - slack);
            EXPECT_LE(elbow, slack);
            EXPECT_LE(std::abs(wrist), 90 + slack);
            atLimit += run.readout("at-limit") > 0;
            farther += limited > read(run.set("limits", "off"), "to-target") + 0.01;
            EXPECT_EQ(run.readout("at-limit"), 0) << "where there is none";
        }
    }
    // The checks can fail: limits are met, and they cost targets.
    EXPECT_GT(atLimit, 10);
    EXPECT_GT(farther, 5);
}

TEST(RobotArm, person_by_splines) {
    DemoRun run("robot-arm", 240, 140);
    run.preset("person");
    run.set("matrices", "on");
    EXPECT_LT(read(run, "turn-jump"), 1e-3);  // the accelerations times the nanocycle before a pose
    for (const char* between : {"straight", "spline"}) {
        run.set("between", between);
        // The poses of a cycle of 84 frames, of which frame 0 is the second; elbow, twist and shoulder as body.cpp has them
        const std::array<double, 4> shoulders{-94, -66, -90, -118}, elbows{18, 38, 26, 20};
        for (std::size_t i = 0; i < 4; ++i) {
            (void)run.picture(static_cast<int>(21 * i));
            EXPECT_NEAR(angleAboutZ(run.matrix("trunkFromShoulder")), shoulders.at(i), 1e-9) << between << " " << i;
            EXPECT_NEAR(angleAboutZ(run.matrix("armFromForearm")), elbows.at(i), 1e-9) << between << " " << i;
        }
    }
    run.set("between", "straight");
    EXPECT_GT(read(run, "turn-jump"), 100);
}

TEST(RobotArm, through_each_other) {
    DemoRun run("robot-arm", 240, 140);
    for (const char* between : {"straight", "spline"}) {
        SCOPED_TRACE(between);
        run.preset("through");
        run.set("between", between);
        for (const int pose : {21, 63}) {
            EXPECT_EQ(read(run, "through", pose), 0) << pose;
            EXPECT_TRUE(run.messages().empty());
        }
        EXPECT_EQ(read(run, "through", 42), 1);
        ASSERT_EQ(run.messages().size(), 1U);
        EXPECT_EQ(run.messages().front(), "The near forearm passes through the trunk.");
        run.set("routine", "hand-around");
        EXPECT_EQ(read(run, "through-most"), 0);
        run.set("routine", "walk");
        EXPECT_EQ(read(run, "through-most"), 0);
    }
    // Its sizes go with the legs', and so nothing changes.
    run.preset("through");
    run.set("upper", 0.3).set("lower", 0.2);
    EXPECT_EQ(read(run, "through", 42), 1);
    EXPECT_EQ(read(run, "through", 21), 0);
}

TEST(RobotArm, foot_slides) {
    DemoRun run("robot-arm", 240, 140);
    run.preset("feet");
    std::vector<double> slides;
    for (const int poses : {4, 8, 16, 32, 64}) slides.push_back(read(run.set("poses", poses), "slide", 100));
    for (std::size_t i = 1; i < slides.size(); ++i) EXPECT_LT(slides[i], slides[i - 1]);
    EXPECT_GT(slides[0], 0.1) << "of legs of 2 m";
    // Straight lines between points of a curve are off by the square of their distance.
    EXPECT_NEAR(slides[3] / slides[4], 4, 1);
    EXPECT_GT(slides[4], 1e-5);
}

TEST(RobotArm, foot_stands) {
    DemoRun run("robot-arm", 240, 140);
    run.preset("feet");
    // Hip and foot are rounded where the body is, a frame of 84 to each cycle of 1.8 m, and the leg of 2 m some times.
    for (const int frame : {0, 30, 100, 84000}) {
        const double away = 2 + 1.8 * (frame / 84.0 + 2);
        EXPECT_LE(read(run, "slip", frame), 1e-15 * away) << frame;
        EXPECT_GT(run.readout("slide"), 0.1) << "beside it";
    }
    // Even where the poses that are played are right to a tenth of a millimetre
    EXPECT_LE(read(run.set("poses", 64), "slip"), 1e-14);
    // By iteration to the tolerance, 1e-9 of the leg; the slowest needs more iterations than there are.
    run.set("poses", 4).set("iterations", 64);
    EXPECT_LE(read(run.set("method", "dls"), "slip"), 2e-9);
    EXPECT_GT(run.readout("slip"), 1e-13) << "it is not the closed form";
    EXPECT_LE(read(run.set("method", "ccd"), "slip"), 1e-8);
    EXPECT_LE(read(run.set("method", "transpose"), "slip"), 1e-3);
}
