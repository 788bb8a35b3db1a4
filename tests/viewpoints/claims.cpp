// The claims of viewpoints, and a test for each.
//
// - [eight-views] Views 1 to 8 have the matrices of the WebGL page, to rounding, all the lap round.
// - [car-faces-ahead] The car points where it drives; the slide's sign would turn it away by twice its direction.
// - [what-stands-still] From outside the car the scenery stands still in the picture, from inside the car does.
// - [lap-of-120] A lap is 120 pictures, each another one, and then begins again.
// - [slide-misses-house] View 5 by the slide's formula misses the house and tilts the horizon, the more the higher.
// - [exact-hits-house] View 5 with eye and target taken to world space has the house in the middle, horizon level.
// - [down-needs-another-up] Straight down, up = z is refused; up = y puts +y at the top and +x to the right.
// - [lookat-by-axes] lookAt is R T(-eye), and R's rows are u, v, w; -R^T t is the eye. A system with its origin at -eye is another.
// - [camera-from-outside] With the camera shown, the axes are drawn above the picture, which is the same in the lower half.
// - [nine-cameras] As it opens, the figure shows nine cameras, one for each view, and marks the chosen one.
// - [lit-and-sky] Lit, a box has another colour on each side that is seen, and level views have a sky above the ground; unlit, a house
//   is one red and the sky is the ground's green.
// - [eye-under-the-roof] In views 4 and 5 a height that puts the eye under the car's roof is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "math/support.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/demo_run.h"
#include "support/random.h"
#include "viewpoints/viewpoints.h"

using namespace mv::test;
using mv::mat4;
using mv::vec3;
using mv::vec4;

namespace {

constexpr int lap = 120;  // pictures of 3 degrees
// The picture of the visits: the matrices do not depend on its size while it is square.
constexpr int small = 70;

// ---- the WebGL page written out once more, with GLM's functions, which take radians

mat4 turn(double degrees, const vec3& axis) { return glm::rotate(mat4(1), glm::radians(degrees), axis); }
mat4 look(const vec3& eye, const vec3& at) { return glm::lookAtRH(eye, at, vec3(0, 0, 1)); }

struct Pair {
    mat4 viewFromWorld, viewFromCar;
};

Pair original(int view, double degrees, double h) {
    const double x = 100 * std::sin(glm::radians(degrees)), y = 100 * std::cos(glm::radians(degrees));
    const vec3 zAxis(0, 0, 1);
    const auto world = [&](const mat4& l) {
        return Pair{l, l * glm::translate(mat4(1), vec3(x, y, 0)) * turn(-degrees, zAxis)};
    };
    const auto car = [&](const mat4& l) {
        return Pair{l * turn(degrees, zAxis) * glm::translate(mat4(1), vec3(-x, -y, 0)), l};
    };
    switch (view) {
        case 1:
            return world(look({250, 0, 100 + h}, {0, 0, 0}));
        case 2:
            return world(look({75, 0, 5 + h}, {x, y, 0}));
        case 3:
            return world(look({125, 0, 5 + h}, {x, y, 0}));
        case 4:
            return car(look({-3, 0, 5 + h}, {12, 0, 2 + h}));
        case 5:
            return car(turn(-degrees, {0, 1, 0}) * look({3, 0, 5 + h}, {40 - x, 120 - y, 0}));
        case 6:
            return car(look({-12, 0, 6 + h}, {15, 0, 4}));
        case 7:
            return car(look({25, 5, 5 + h}, {0, 0, 2}));
        default:
            return car(look({2, 20, 5 + h}, {2, 0, 2}));
    }
}

// The place of a point of the world in the picture, -1 to 1 across and upwards.
vec3 seenAt(DemoRun& run, const vec3& point) {
    return mv::ndcFromClip(run.matrix("clipFromView") * run.matrix("viewFromWorld") * vec4(point, 1));
}

struct Worst {
    double miss = 0, roll = 0;  // degrees
};

// The largest miss and roll of a lap, from the matrix alone: where the eye is and what its axes are in the world.
Worst worstOfLap(DemoRun& run, double aim) {
    Worst worst;
    for (int frame = 0; frame < lap; ++frame) {
        run.picture(frame);
        const mat4 worldFromView = glm::inverse(run.matrix("viewFromWorld"));
        const vec3 ahead(worldFromView * vec4(0, 0, -1, 0)), right(worldFromView * vec4(1, 0, 0, 0));
        const vec3 wanted = glm::normalize(vec3(40, 120, aim) - vec3(worldFromView * vec4(0, 0, 0, 1)));
        const double miss = glm::degrees(std::asin(std::min(1.0, length(cross(ahead, wanted)))));
        EXPECT_GT(dot(ahead, wanted), 0);
        // The horizon's tilt: the right axis leaves the level plane by this much of what it could, cos(pitch).
        const double roll = glm::degrees(std::asin(std::abs(right.z) / std::hypot(ahead.x, ahead.y)));
        // 1e-6 degrees: the asin of a sine near 0 has the accuracy of the matrix, 1e-14 radians, with a wide margin.
        EXPECT_NEAR(run.readout("miss"), miss, 1e-6);
        EXPECT_NEAR(run.readout("roll"), roll, 1e-6);
        worst = {std::max(worst.miss, miss), std::max(worst.roll, roll)};
    }
    return worst;
}

}  // namespace

TEST(ViewpointsFull, eight_views) {
    DemoRun run("viewpoints", small, small);
    for (int view = 1; view <= 8; ++view) {
        for (const double height : {0.0, 12.0}) {
            run.set("view", std::to_string(view)).set("height", height);
            for (int frame = 0; frame < lap; frame += 5) {
                run.picture(frame);
                const Pair page = original(view, 3.0 * frame, height);
                // Coordinates up to 300, each from some ten products: 300 * 10 * 1.1e-16 = 3e-13.
                EXPECT_LT(largestDifference(run.matrix("viewFromWorld"), page.viewFromWorld), 1e-12)
                    << "view " << view << ", frame " << frame;
                EXPECT_LT(largestDifference(run.matrix("viewFromCar"), page.viewFromCar), 1e-12)
                    << "view " << view << ", frame " << frame;
            }
        }
    }
    // perspective(50, 1, 1, 500) as MV.js prints it: 10 decimals.
    EXPECT_NEAR(run.matrix("clipFromView")[1][1], 2.1445069205, 1e-10);
    EXPECT_NEAR(run.matrix("clipFromView")[2][2], -1.0040080160, 1e-10);
    EXPECT_NEAR(run.matrix("clipFromView")[3][2], -2.0040080160, 1e-10);
}

TEST(Viewpoints, car_faces_ahead) {
    DemoRun run("viewpoints", small, small);
    const auto worldFromCar = [&](int frame) {
        run.picture(frame);
        return glm::inverse(run.matrix("viewFromWorld")) * run.matrix("viewFromCar");
    };
    for (const char* view : {"1", "4"}) {
        run.set("view", view);
        for (int frame = 1; frame < lap; frame += 7) {
            const vec3 path = glm::normalize(vec3(worldFromCar(frame + 1)[3] - worldFromCar(frame - 1)[3]));
            const mat4 car = worldFromCar(frame);
            // A chord from one frame before to one after is parallel to the tangent between them.
            EXPECT_NEAR(dot(path, vec3(car[0])), 1, 1e-12) << "frame " << frame;
            // The slide's sign with today's rotateZ: away from the path by twice the direction.
            const vec3 slide(turn(3.0 * frame, {0, 0, 1})[0]);
            EXPECT_NEAR(dot(path, slide), std::cos(glm::radians(6.0 * frame)), 1e-12);
        }
    }
}

TEST(Viewpoints, what_stands_still) {
    DemoRun run("viewpoints", small, small);
    for (const char* view : {"1", "4", "6", "7", "8", "9"}) {
        run.set("view", view);
        run.picture(3);
        const mat4 world = run.matrix("viewFromWorld"), car = run.matrix("viewFromCar");
        run.picture(40);
        const bool outside = view[0] == '1' || view[0] == '9';
        EXPECT_EQ(run.matrix("viewFromWorld") == world, outside) << view;
        EXPECT_EQ(run.matrix("viewFromCar") == car, !outside) << view;
    }
    // Views 2 and 3 turn after the car, but the eye keeps its place.
    for (const auto& [view, x] : {std::pair{"2", 75.0}, {"3", 125.0}}) {
        run.set("view", view).picture(40);
        const vec3 eye(glm::inverse(run.matrix("viewFromWorld"))[3]);
        EXPECT_NEAR(length(eye - vec3(x, 0, 5)), 0, 1e-12);  // rounding of coordinates of 100
    }
}

TEST(ViewpointsFull, lap_of_120) {
    DemoRun run("viewpoints", 300, 300);  // large enough that 3 degrees move the far car by a pixel
    run.set("view", "3");
    const mv::Picture first = run.picture(0);
    EXPECT_EQ(run.readout("direction"), 0);
    EXPECT_EQ(run.picture(lap), first);
    EXPECT_EQ(run.readout("direction"), 0);
    mv::Picture before = run.picture(lap - 1);
    for (int frame = 0; frame < lap; ++frame) {
        const mv::Picture now = run.picture(frame);
        EXPECT_GT(differentPixels(before, now), 0) << frame;
        EXPECT_EQ(run.readout("direction"), 3.0 * frame);
        before = now;
    }
}

TEST(ViewpointsFull, slide_misses_house) {
    DemoRun run("viewpoints", small, small);
    run.set("view", "5");
    struct Case {
        double height, aim, miss, roll;
    };
    // Largest of a lap in degrees, to the printed digit: hence the tolerance of half of it. The first looks level.
    for (const Case& c : {Case{0, 5, 1.8, 0.0}, {0, 0, 3.0, 4.1}, {10, 0, 7.9, 12.0}, {20, 0, 13.0, 19.5}}) {
        const Worst worst = worstOfLap(run.set("height", c.height).set("aim", c.aim), c.aim);
        EXPECT_NEAR(worst.miss, c.miss, 0.05) << "height " << c.height;
        EXPECT_NEAR(worst.roll, c.roll, 0.05) << "height " << c.height;
    }
}

TEST(ViewpointsFull, exact_hits_house) {
    DemoRun run("viewpoints", small, small);
    run.set("view", "5").set("exact", "on");
    for (const double height : {0.0, 10.0, 20.0}) {
        const Worst worst = worstOfLap(run.set("height", height), 0);
        // 1e-12 radians: an axis of a matrix from coordinates of 100 is good to some 1e-14.
        EXPECT_LT(worst.miss, 1e-10);
        EXPECT_LT(worst.roll, 1e-10);
        const vec3 house = seenAt(run, {40, 120, 0});
        EXPECT_NEAR(house.x, 0, 1e-12);
        EXPECT_NEAR(house.y, 0, 1e-12);
    }
    // The eye rides with the car: 3 ahead of its middle, and the car is turned right.
    run.picture(45);
    const Pair page = original(4, 135, 0);
    const mat4 carFromWorld = glm::inverse(page.viewFromCar) * page.viewFromWorld;
    const vec3 eye(carFromWorld * glm::inverse(run.matrix("viewFromWorld")) * vec4(0, 0, 0, 1));
    EXPECT_NEAR(length(eye - vec3(3, 0, 25)), 0, 1e-12);
}

TEST(Viewpoints, down_needs_another_up) {
    EXPECT_THROW(mv::lookAt(vec3(0, 0, 200), vec3(0, 0, 0), vec3(0, 0, 1)), mv::Error);
    DemoRun run("viewpoints");
    run.set("camera", "off").set("lit", "off");
    const mv::Picture picture = run.set("view", "9").set("height", 40).picture(30);
    const vec3 middle = seenAt(run, {0, 0, 0}), north = seenAt(run, {0, 90, 0}), east = seenAt(run, {90, 0, 0});
    EXPECT_NEAR(length(middle - vec3(0, 0, middle.z)), 0, 1e-12);
    EXPECT_NEAR(north.x, 0, 1e-12);
    EXPECT_NEAR(east.y, 0, 1e-12);
    EXPECT_GT(north.y, 0.8);
    EXPECT_GT(east.x, 0.8);
    // The car, after a quarter of the lap, is at the right; the whole track is in the picture.
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const mv::Pixel p = picture.at(x, y);
            if (p.blue == 255 && p.red == 0) {
                EXPECT_GT(x, picture.width * 9 / 10);
            }
            const bool rim = x == 0 || y == 0 || x == picture.width - 1 || y == picture.height - 1;
            if (rim) {
                EXPECT_EQ(p, picture.at(0, 0));
            }
        }
    }
    EXPECT_GT(countPixels(picture, {0, 0, 255}), 100);
}

TEST(Viewpoints, lookat_by_axes) {
    Random random(1);
    const auto place = [&] { return random.point(200); };
    for (int i = 0; i < 1000; ++i) {
        const mv::viewpoints::Gaze gaze{place(), place(), mv::viewpoints::Space::world, place()};
        const auto [u, v, w] = axesOf(gaze);
        // Unit vectors, each perpendicular to the others, and right-handed. Some ten roundings of 1
        EXPECT_NEAR(length(u), 1, 2e-15);
        EXPECT_NEAR(length(cross(u, v) - w), 0, 2e-15);
        EXPECT_NEAR(dot(u, gaze.up), 0, 1e-13);  // up is 200 long
        EXPECT_GT(dot(v, gaze.up), 0);
        EXPECT_GT(dot(w, gaze.eye - gaze.at), 0);
        // Coordinates of 350, three products and sums each; up may be as near as 0.01 to the gaze, which takes two digits
        const mat4 byAxes = viewByAxes(gaze), look = mv::lookAt(gaze.eye, gaze.at, gaze.up);
        EXPECT_LT(largestDifference(byAxes, look), 1e-11);
        EXPECT_NEAR(length(mv::viewpoints::eyeOf(look) - gaze.eye), 0, 1e-12);
        const vec3 origin(look * vec4(gaze.eye, 1));
        EXPECT_NEAR(length(origin), 0, 1e-12);
        // The slide's words: a system with its origin at -eye has a translation by +eye
        const mat4 slide = turnInto(axesOf(gaze)) * mv::translate(gaze.eye);
        EXPECT_NEAR(length(vec3(slide * vec4(gaze.eye, 1))), 2 * length(gaze.eye), 1e-12);
    }
}

TEST(Viewpoints, camera_from_outside) {
    for (int view = 1; view <= 9; ++view) {
        DemoRun whole("viewpoints", 400, 400);
        whole.set("view", std::to_string(view)).set("camera", "one");
        const mv::Picture both = whole.picture(15);
        const long red = countPixels(both, {204, 26, 26}), green = countPixels(both, {0, 115, 26}),
                   blue = countPixels(both, {26, 64, 230});
        // An arrow two pixels wide and longer than it is wide
        EXPECT_GT(std::min({red, green, blue}), 10) << view;
        DemoRun half("viewpoints", 400, 200);
        const mv::Picture below = half.set("view", std::to_string(view)).set("camera", "off").picture(15);
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 400; ++x) ASSERT_EQ(both.at(x, 200 + y), below.at(x, y)) << view;
        }
    }
}

TEST(ViewpointsFull, nine_cameras) {
    constexpr mv::Pixel chosen{204, 77, 0};
    for (int view = 1; view <= 9; ++view) {
        DemoRun run("viewpoints");
        const mv::Picture all = run.set("view", std::to_string(view)).picture(15);
        // The disc of the chosen one is so coloured, and where that is it is white when another one is chosen
        long marked = 0, white = 0;
        DemoRun another("viewpoints");
        const mv::Picture others = another.set("view", view == 9 ? "1" : "9").picture(15);
        for (int y = 0; y < 350; ++y) {
            for (int x = 0; x < 700; ++x) {
                if (!sameColor(all.at(x, y), chosen)) continue;
                ++marked;
                white += sameColor(others.at(x, y), {255, 255, 255});
            }
        }
        EXPECT_GT(marked, 200) << view;
        EXPECT_GT(white, 100) << view;
    }
}

TEST(Viewpoints, lit_and_sky) {
    DemoRun run("viewpoints");
    run.preset("original");
    const auto reds = [&] {
        const mv::Picture picture = run.picture();
        std::set<int> colors;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                const mv::Pixel p = picture.at(x, y);
                if (p.red > 60 && p.green == 0 && p.blue == 0) colors.insert(p.red);
            }
        }
        return colors.size();
    };
    EXPECT_EQ(reds(), 1U);
    run.set("view", "3");
    EXPECT_EQ(run.picture().at(350, 5), run.picture().at(350, 690)) << "the sky and the ground";
    run.set("lit", "on");
    EXPECT_NE(run.picture().at(350, 5), run.picture().at(350, 690));
    // Level, the horizon is in the middle of the picture, to two rows
    run.set("view", "2");
    const mv::Picture seen = run.picture();
    int horizon = 0;
    while (horizon < 699 && seen.at(20, horizon) == seen.at(20, 0)) ++horizon;
    const double pitch = std::asin(glm::inverse(run.matrix("viewFromWorld"))[2].z);
    EXPECT_NEAR(horizon, 350 - 350 * 2.1445069205 * std::tan(pitch), 2);
    run.set("view", "1");
    EXPECT_GE(reds(), 3U) << "the shades of three sides";
}

TEST(ViewpointsFull, eye_under_the_roof) {
    DemoRun run("viewpoints", small, small);
    // A view that is allowed shows more than one colour all the lap round, in every view.
    for (int view = 1; view <= 9; ++view) {
        for (const double height : {-4.0, -3.0, -2.0, -1.0}) {
            run.set("view", std::to_string(view)).set("height", height);
            const bool refused = (view == 4 || view == 5) && height < -1;
            EXPECT_EQ(run.refusal().rfind("--height: must be at least", 0) == 0, refused) << view << ", " << height;
            if (refused) continue;
            for (int frame = 0; frame < lap; frame += 3) {
                EXPECT_GT(countColors(run.picture(frame), 2), 1) << view << ", " << height << ", frame " << frame;
            }
        }
    }
}
