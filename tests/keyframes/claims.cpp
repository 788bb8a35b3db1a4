// The claims of keyframes, and a test for each.
//
// - [through-its-keys] Every kind of curve but the B-spline and the Bezier curve is at each key at the key's time.
// - [formulas] The page's formulas of polynomial, spline, Catmull-Rom, B-spline and Bezier curve are those that are drawn.
// - [speed-jumps] Straight from key to key the speed is constant, and jumps at the keys. A spline's does not; that of a
//   uniform Catmull-Rom curve does not either, but its acceleration does.
// - [ends] Where it rests before and after, all kinds leave with a jump, but what is eased at both ends and the clamped
//   spline.
// - [who-feels-a-key] A moved key changes four spans of a Catmull-Rom curve or a B-spline, more of a spline, and all of one
//   polynomial.
// - [swings] Through more and more even nodes of Runge's function one polynomial swings more and more, and says so from 13
//   on; through as many of Chebyshev's, or in a spline, it comes nearer and nearer.
// - [float-swings-too] Even where the polynomial comes near, at sin 3x, 41 even nodes are too many for the textbook's form
//   in float.
// - [dolly-zoom] The angle of view computed from the distance keeps the subject's size; an angle with keys of its own has it
//   at the keys, and less between them. The things behind the subject swell.
// - [camera-keys] Each of a camera's five properties has keys of its own: at a key's time its matrices are those of the key, and where
//   one property alone moves the others stay.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "keyframes/key_curve.h"
#include "mv/demo/demo.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::vector<std::string> kinds{"linear",   "ease",        "lagrange",    "natural",  "clamped",
                                     "periodic", "catmull-rom", "centripetal", "b-spline", "bezier"};

const std::vector<vec2> initialKeys{{0.5, 2}, {1.5, 7.5}, {4, 9}, {5, 4.5}, {8, 1}, {9.5, 7}};

// Whether the orange ball, 12 pixels in radius, has its middle within a pixel of that place, of 12.5 m over 560 pixels: then
// it covers what is 11 pixels away on four sides.
bool isBallAt(const Picture& picture, const vec2& place) {
    const vec2 at = vec2(280) + 560 / 12.5 * (place - vec2(5));
    return std::ranges::all_of(std::array{vec2(11, 0), vec2(-11, 0), vec2(0, 11), vec2(0, -11)}, [&](const vec2& side) {
        const vec2 there = at + side;
        const Pixel pixel = picture.at(static_cast<int>(there.x), picture.height - 1 - static_cast<int>(there.y));
        return std::abs(pixel.red - 230) < 12 && std::abs(pixel.green - 128) < 12 && pixel.blue < 60;
    });
}

// The lines above the picture's middle with a pixel of the figure's body or head, in the column through it.
int subjectLines(const Picture& picture) {
    int lines = 0;
    for (int y = 0; y < picture.height / 2; ++y) {
        const Pixel pixel = picture.at(280, y);
        lines += pixel.red > 130 && pixel.red > pixel.blue + 45 && pixel.red > pixel.green + 25;
    }
    return lines;
}

// Equal to some roundings of numbers below 10.
void expectClose(const mat4& a, const mat4& b) {
    for (int column = 0; column < 4; ++column) EXPECT_LT(glm::length(a[column] - b[column]), 1e-12) << column;
}

double errorOf(DemoRun& run, int nodes, const char* readout) {
    (void)run.set("nodes", nodes).picture();
    return run.readout(readout);
}

}  // namespace

TEST(KeyframesFull, through_its_keys) {
    DemoRun run("keyframes", 960, 560);
    for (const std::string& kind : kinds) {
        SCOPED_TRACE(kind);
        run.set("curve", kind);
        const bool passesBy = kind == "b-spline" || kind == "bezier";
        for (std::size_t i = 0; i < initialKeys.size(); ++i) {
            const bool isEnd = i == 0 || i + 1 == initialKeys.size();
            const int frame = static_cast<int>(60 * i) + (kind == "periodic" ? 0 : 30);  // a key a second, after a rest
            EXPECT_EQ(isBallAt(run.picture(frame), initialKeys[i]), isEnd || !passesBy) << "key " << i;
        }
        // Half a second later it is elsewhere.
        EXPECT_FALSE(isBallAt(run.picture(120), initialKeys[1]));
        // Within the hull of its keys
        EXPECT_TRUE(!passesBy || run.readout("overshoot") < 1e-12);
    }
}

TEST(Keyframes, speed_jumps) {
    DemoRun run("keyframes", 240, 140);
    const auto jump = [&](const std::string& kind, const char* readout) {
        (void)run.set("curve", kind).picture();
        return run.readout(readout);
    };
    // The keys are a second apart
    double largest = 0;
    for (std::size_t i = 1; i + 1 < initialKeys.size(); ++i) {
        largest = std::max(largest, glm::length(initialKeys[i + 1] - 2.0 * initialKeys[i] + initialKeys[i - 1]));
    }
    EXPECT_NEAR(jump("linear", "velocity-jump"), largest, 1e-12);
    // Roundings of velocities of 10 m/s and accelerations of 50 m/s^2, and the step to the side of a key, 1e-15 s.
    for (const std::string kind : {"natural", "clamped", "periodic", "lagrange", "bezier", "b-spline"}) {
        EXPECT_LT(jump(kind, "velocity-jump"), 1e-12) << kind;
        EXPECT_LT(jump(kind, "acceleration-jump"), 1e-11) << kind;
    }
    EXPECT_LT(jump("catmull-rom", "velocity-jump"), 1e-12);
    EXPECT_GT(jump("catmull-rom", "acceleration-jump"), 1);
    // Its knots are not the keys' times, so that its velocity keeps the direction alone.
    EXPECT_GT(jump("centripetal", "velocity-jump"), 0.1);
    // An ease that ends at 0 and starts at 0 jumps nowhere: the quadratic ease does not end so.
    run.set("ease", "bezier");
    EXPECT_LT(jump("ease", "velocity-jump"), 1e-12);
    run.set("ease", "quadratic");
    EXPECT_GT(jump("ease", "velocity-jump"), 1);
}

TEST(Keyframes, ends) {
    DemoRun run("keyframes", 240, 140);
    for (const std::string& kind : kinds) {
        SCOPED_TRACE(kind);
        (void)run.set("curve", kind).set("ease", "bezier").picture();
        if (kind == "clamped" || kind == "ease" || kind == "periodic") {
            EXPECT_LT(run.readout("end-jump"), 1e-12);
        } else {
            EXPECT_GT(run.readout("end-jump"), 1);
        }
    }
    run.set("curve", "ease");
    for (const char* ease : {"quadratic", "logistic"}) {
        (void)run.set("ease", ease).picture();
        EXPECT_GT(run.readout("end-jump"), 0.1) << ease;
    }
    // The root starts at infinite speed, which no readout has and a sentence says.
    (void)run.set("ease", "root").picture();
    EXPECT_FALSE(run.measured("end-jump"));
    EXPECT_FALSE(run.measured("velocity-jump"));
    EXPECT_EQ(run.messages().size(), 1U);
}

// Moves the fifth of keys 0 to 9 and looks in which spans the way differs; key i is at x = i.
TEST(Keyframes, who_feels_a_key) {
    DemoRun run("keyframes", 960, 560);
    const auto felt = [&](const char* kind) {
        std::array<Picture, 2> pictures;
        for (const bool isMoved : {false, true}) {
            std::string keys;
            for (int i = 0; i < 10; ++i) {
                const double y = i == 5 && isMoved ? 5.5 : 5 + (i % 2) * 0.3;
                keys += (i > 0 ? "/" : "") + std::to_string(i) + "," + numberText(y);
            }
            pictures.at(isMoved) = run.set("curve", kind).set("points", keys).picture(10);
        }
        int first = 10, last = -1;
        for (int span = 0; span < 9; ++span) {
            // Between two keys' discs of 20 pixels, which are 45 apart
            const double metre = 560 / 12.5;
            const int middle = static_cast<int>(280 + metre * (span + 0.5 - 5));
            bool differs = false;
            for (int x = middle - 2; x <= middle + 2; ++x) {
                for (int y = 60; y < 560; ++y) differs |= pictures[0].at(x, y) != pictures[1].at(x, y);
            }
            if (!differs) continue;
            first = std::min(first, span);
            last = std::max(last, span);
        }
        return std::array{first, last};
    };
    EXPECT_EQ(felt("linear"), (std::array{4, 5}));
    EXPECT_EQ(felt("catmull-rom"), (std::array{3, 6}));
    EXPECT_EQ(felt("b-spline"), (std::array{3, 6}));
    EXPECT_EQ(felt("lagrange"), (std::array{0, 8}));
    // The effect on a spline fades, by a factor of 3.7 a key, and so below what a pixel shows.
    EXPECT_LT(felt("natural")[0], 3);
    EXPECT_GT(felt("natural")[1], 6);
}

TEST(KeyframesFull, swings) {
    DemoRun run("keyframes", 240, 140);
    run.set("scene", "runge").set("curve", "natural");
    double last = 0;
    for (const int nodes : {5, 7, 9, 11, 13, 21, 31, 41, 61, 81}) {
        const double error = errorOf(run, nodes, "polynomial-error");
        EXPECT_TRUE(nodes == 5 || error > last) << nodes;
        last = error;
        EXPECT_EQ(run.messages().size(), nodes >= 13 ? 1U : 0U) << nodes;
    }
    EXPECT_NEAR(errorOf(run, 21, "polynomial-error"), 60, 0.5);  // as the literature has it
    EXPECT_NEAR(last, 5e11, 0.6e11);                             // to one digit
    // Both come nearer with each node that is added.
    for (const char* spread : {"even", "chebyshev"}) {
        run.set("nodes-at", spread);
        const char* readout = std::string(spread) == "even" ? "curve-error" : "polynomial-error";
        double before = 1;
        for (const int nodes : {5, 11, 21, 41, 81}) {
            const double error = errorOf(run, nodes, readout);
            EXPECT_LT(error, before) << readout << " " << nodes;
            before = error;
        }
        EXPECT_LT(before, 1e-4);
        EXPECT_EQ(run.messages().empty(), std::string(spread) == "chebyshev");
    }
}

TEST(Keyframes, float_swings_too) {
    DemoRun run("keyframes", 240, 140);
    run.set("scene", "runge").set("function", "sine").set("curve", "natural");
    // In double the nodes' roundings of 1e-16, 41 nodes' constant of 1e10 at most: 1e-5.
    EXPECT_LT(errorOf(run, 41, "polynomial-error"), 1e-5);
    EXPECT_LT(errorOf(run.set("form", "textbook"), 41, "polynomial-error"), 1e-5);
    // In float 6e-8 of them: larger than the function.
    EXPECT_GT(errorOf(run.set("form", "float"), 41, "polynomial-error"), 1);
    EXPECT_LT(errorOf(run, 21, "polynomial-error"), 0.01);
}

TEST(KeyframesFull, dolly_zoom) {
    DemoRun run("keyframes", 960, 560);
    run.set("scene", "camera");
    for (const char* kind : {"linear", "ease", "natural", "clamped", "periodic", "catmull-rom", "bezier"}) {
        SCOPED_TRACE(kind);
        run.set("curve", kind);
        (void)run.set("zoom", "computed").picture(0);
        const double size = run.readout("subject-size");
        double door = run.readout("door-size"), smallest = size;
        for (int frame = 20; frame <= 180; frame += 20) {
            (void)run.set("zoom", "computed").picture(frame);
            EXPECT_NEAR(run.readout("subject-size"), size, 1e-14) << frame;
            EXPECT_GE(run.readout("door-size"), door) << frame;
            door = run.readout("door-size");
            (void)run.set("zoom", "keys").picture(frame);
            smallest = std::min(smallest, run.readout("subject-size"));
        }
        EXPECT_GT(door, 2 * size * 3 / 2 * 4 / 24) << "from 4 m and 24 m away to more than twice that";
        if (std::string(kind) == "bezier") continue;  // which is at no key but the first and the last
        (void)run.set("zoom", "keys").picture(0);
        EXPECT_NEAR(run.readout("subject-size"), size, 1e-12);
        (void)run.set("zoom", "keys").picture(180);
        EXPECT_NEAR(run.readout("subject-size"), size, 1e-12);
        EXPECT_LT(smallest, 0.6 * size);
    }
    // The same in pixels, of the half of the figure that is above the camera: a line or two more than its axis has, since a
    // ball of 0.35 m is seen from 4 m (1 % of 150 lines), less those of the line drawn over its top.
    run.set("curve", "linear").set("zoom", "computed");
    for (const int frame : {0, 45, 90, 135, 180}) {
        const Picture picture = run.picture(frame);
        EXPECT_NEAR(subjectLines(picture), run.readout("subject-size") * 560 / 2, 3) << frame;
    }
    const int lines = subjectLines(run.picture(0));
    EXPECT_LT(subjectLines(run.set("zoom", "keys").picture(90)), 0.6 * lines);
}

TEST(Keyframes, camera_keys) {
    DemoRun run("keyframes", 240, 140);
    run.preset("flight");
    // The first key and the second, which is at 2 s
    const vec3 eye(0, 1, 6), center(0, 1, 0), up(0, 1, 0), eyeThen(3.5, 2.5, 5), centerThen(0, 1.6, 0),
        upThen(0.4, 1, 0);
    struct Case {
        const char* moves;
        mat4 view, clip;
    };
    const mat4 view = lookAt(eye, center, up), clip = perspective(50, 1, 0.1, 300);
    for (const Case& c : {Case{"all", lookAt(eyeThen, centerThen, upThen), perspective(35, 2.35, 0.1, 300)},
                          {"eye", lookAt(eyeThen, center, up), clip},
                          {"center", lookAt(eye, centerThen, up), clip},
                          {"up", lookAt(eye, center, upThen), clip},
                          {"aspect", view, perspective(50, 2.35, 0.1, 300)},
                          {"fovy", view, perspective(35, 1, 0.1, 300)}}) {
        SCOPED_TRACE(c.moves);
        (void)run.set("moves", c.moves).picture(0);
        expectClose(run.matrix("viewFromWorld"), view);
        expectClose(run.matrix("clipFromView"), clip);
        const Picture at = run.picture(120);
        expectClose(run.matrix("viewFromWorld"), c.view);
        expectClose(run.matrix("clipFromView"), c.clip);
        // Half a second later, between keys, it is another picture.
        EXPECT_GT(differentPixels(run.picture(150), at), 100);
    }
    // The demo refuses what would turn the picture inside out: an ease that swings beyond the keys makes an aspect below 0.1.
    run.preset("flight");
    EXPECT_EQ(run.refusal(), "");
    run.set("curve", "ease").set("ease", "elastic");
    EXPECT_NE(run.refusal().find("--ease: must keep the camera off what it looks at"), std::string::npos)
        << run.refusal();
}

TEST(Keyframes, formulas) {
    const std::vector<double> g{0.5, 1.5, 4, 5, 8, 2};
    const int n = 5;
    std::vector<Keyframe<double>> keys;
    for (const double value : g) keys.push_back({double(keys.size()), value});
    const auto motionOf = [&](KeyCurve::Kind kind) {
        KeyCurve curve;
        curve.kind = kind;
        return curve.through(keys, 0.0, 0.0);
    };
    const auto key = [&](int i) { return g[std::size_t(i)]; };
    const auto lagrange = motionOf(KeyCurve::Kind::lagrange), spline = motionOf(KeyCurve::Kind::natural),
               catmullRom = motionOf(KeyCurve::Kind::catmullRom), bSpline = motionOf(KeyCurve::Kind::bSpline),
               bezier = motionOf(KeyCurve::Kind::bezier);
    // Some twenty roundings of numbers up to 10, and up to 8 times as much in the polynomial, whose weights swing
    constexpr double roundings = 1e-13;

    // The spline's accelerations solve the page's equations
    std::vector<double> a;
    for (int i = 0; i < n; ++i) a.push_back(spline.at(i).acceleration);
    a.push_back(spline.before(n).acceleration);
    EXPECT_NEAR(a.front(), 0, roundings);
    EXPECT_NEAR(a.back(), 0, 1e-12);  // a place before the last key, by the slope of 20 at most times its last place
    for (int i = 1; i < n; ++i) {
        const double left = a[std::size_t(i) - 1] + 4 * a[std::size_t(i)] + a[std::size_t(i) + 1];
        EXPECT_NEAR(left, 6 * (key(i - 1) - 2 * key(i) + key(i + 1)), 1e-11) << i;
    }

    for (int step = 0; step < 10 * n; ++step) {
        const double t = (step + 0.5) / 10, u = t - std::floor(t), v = 1 - u;
        const int i = int(t);
        double polynomial = 0, bernstein = 0, over = 1;
        for (int k = 0; k <= n; ++k) {
            double product = key(k);
            for (int j = 0; j <= n; ++j) product *= j == k ? 1 : (t - j) / (k - j);
            polynomial += product;
            bernstein += over * std::pow(t / n, k) * std::pow(1 - t / n, n - k) * key(k);
            over = over * (n - k) / (k + 1);
        }
        EXPECT_NEAR(lagrange.position(t), polynomial, 8 * roundings) << t;
        EXPECT_NEAR(bezier.position(t), bernstein, roundings) << t;
        EXPECT_NEAR(spline.position(t),
                    v * key(i) + u * key(i + 1) + (v * v * v - v) * a[std::size_t(i)] / 6 +
                        (u * u * u - u) * a[std::size_t(i) + 1] / 6,
                    roundings)
            << t;
        if (i == 0 || i == n - 1) continue;  // what is missing at the ends is another matter
        const double vi = (key(i + 1) - key(i - 1)) / 2, vj = (key(i + 2) - key(i)) / 2;
        EXPECT_NEAR(catmullRom.position(t),
                    (2 * u * u * u - 3 * u * u + 1) * key(i) + (u * u * u - 2 * u * u + u) * vi +
                        (3 * u * u - 2 * u * u * u) * key(i + 1) + (u * u * u - u * u) * vj,
                    roundings)
            << t;
        EXPECT_NEAR(bSpline.position(t),
                    (v * v * v * key(i - 1) + (3 * u * u * u - 6 * u * u + 4) * key(i) +
                     (-3 * u * u * u + 3 * u * u + 3 * u + 1) * key(i + 1) + u * u * u * key(i + 2)) /
                        6,
                    roundings)
            << t;
    }
}
