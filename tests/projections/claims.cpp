// The claims of projections, and a test for each.
//
// - [views-line-up] In the CAD panes each corner is right below its place in the top view and level with it at the side.
// - [shortening-as-theory] The three axes are as short as the formulas say; in the isometric view sqrt(2/3), all of them.
// - [squares-sum-to-two] The squares of the three shortenings add up to 2 in every axonometric view.
// - [only-face-on] Lengths and angles are kept on faces parallel to the picture and nowhere else (cavalier: depths, too).
// - [one-two-three] There are as many vanishing points as axes that are not parallel to the picture.
// - [lines-meet] Each edge of the walls, drawn longer, runs to the image of its direction, the point with w = 0.
// - [eye-on-the-horizon] Points at the height of the eye are on the horizon, at any distance.
// - [far-eye-is-parallel] The farther the eye the nearer the perspective is to the parallel view: in proportion 1/distance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 479, height = 359;  // of a pane: 960 x 720 less the lines between, halved
constexpr Pixel axisColors[3]{{204, 26, 26}, {13, 128, 26}, {26, 64, 230}}, paper{255, 255, 255};
enum Corner { upperLeft, upperRight, lowerLeft, lowerRight };

const vec3 middle(1.5, 3, 0);
vec3 unit(int axis) {
    vec3 direction(0);
    direction[axis] = 1;
    return direction;
}

// A pane of the picture, without the words in its upper left and lower left corners.
Picture paneOf(const Picture& picture, Corner corner) {
    Picture pane(width, height);
    const int left = corner % 2 * (width + 1), top = corner / 2 * (height + 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool words = (x < 320 && (y < 32 || y >= height - 30)) || (x < 200 && y < 50);
            const Pixel p = words ? paper : picture.at(left + x, top + y);
            const std::size_t i = 4 * pixelIndex(x, y, width);
            pane.rgba[i] = p.red;
            pane.rgba[i + 1] = p.green;
            pane.rgba[i + 2] = p.blue;
        }
    }
    return pane;
}

// Pixels from the lower left corner of the pane.
vec2 pixelOf(const mat4& clipFromWorld, const vec3& point) {
    return pixelFromNdc(ndcFromClip(clipFromWorld * vec4(point, 1)), width, height);
}

// How a vector of the world is drawn by a parallel view, in metres of a picture that shows `half` of them upwards.
vec2 drawn(const mat4& clipFromWorld, const vec3& vector, double half) {
    const vec2 pixels = pixelOf(clipFromWorld, middle + vector) - pixelOf(clipFromWorld, middle);
    return pixels * (2 * half / height);
}
double length(const mat4& clipFromWorld, const vec3& vector, double half) {
    return glm::length(drawn(clipFromWorld, vector, half));
}
double angle(const mat4& m, const vec3& a, const vec3& b) {
    const vec2 u = drawn(m, a, 1), v = drawn(m, b, 1);
    return degrees(std::atan2(std::abs(u.x * v.y - u.y * v.x), glm::dot(u, v)));
}

struct Extent {
    int left = width, right = -1, top = height, bottom = -1;
};
// Pixels of the house's edges, which are drawn in the colour of words.
Extent extentOfDrawing(const Picture& pane) {
    Extent extent;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (!sameColor(pane.at(x, y), {26, 26, 26})) continue;
            extent = {std::min(extent.left, x), std::max(extent.right, x), std::min(extent.top, y),
                      std::max(extent.bottom, y)};
        }
    }
    return extent;
}

vec3 wallCorner(int i) { return {(i & 1) != 0 ? 4 : -4, (i & 2) != 0 ? 3 : 0, (i & 4) != 0 ? 3 : -3}; }

// Numbers of some hundred pixels, made of a dozen roundings.
constexpr double pixelRounding = 1e-11;

}  // namespace

TEST(Projections, views_line_up) {
    DemoRun run("projections");
    const Picture picture = run.picture();
    const mat4 top = run.matrix("topFromWorld"), front = run.matrix("frontFromWorld"),
               side = run.matrix("sideFromWorld");
    for (const fvec3& position : meshOf(house()).positions) {
        const vec3 p(position);
        EXPECT_NEAR(pixelOf(top, p).x, pixelOf(front, p).x, pixelRounding);
        EXPECT_NEAR(pixelOf(side, p).y, pixelOf(front, p).y, pixelRounding);
        // A point towards the front is down in the top view and left in the side view, by as much
        EXPECT_NEAR(pixelOf(top, p).y - height / 2.0, pixelOf(side, p).x - width / 2.0, pixelRounding);
    }
    // In the pixels, too: the house begins and ends at the same columns, and at the same rows.
    const Extent fromAbove = extentOfDrawing(paneOf(picture, upperLeft)),
                 fromFront = extentOfDrawing(paneOf(picture, lowerLeft)),
                 fromSide = extentOfDrawing(paneOf(picture, lowerRight));
    EXPECT_EQ(fromAbove.left, fromFront.left);
    EXPECT_EQ(fromAbove.right, fromFront.right);
    EXPECT_EQ(fromSide.top, fromFront.top);
    EXPECT_EQ(fromSide.bottom, fromFront.bottom);
    EXPECT_GT(fromFront.right - fromFront.left, 300);
}

TEST(ProjectionsFull, shortening_as_theory) {
    DemoRun run("projections");
    for (const char* show : {"cad", "axonometric", "oblique"}) {
        run.set("show", show);
        for (const double turn : {-300, -45, 0, 10, 90, 180}) {
            for (const double tilt : {-90, -20, 0, 35, 90}) {
                run.set("turn", turn).set("tilt", tilt).set("angle", turn / 2).set("length", tilt / 90 + 1).picture();
                EXPECT_LT(run.readout("shortening-error"), 1e-14) << show;  // metres of about 1
            }
        }
    }
    // The formulas' own values, in the matrices, and in the pixels of the axes, which are two metres long
    const double third = std::sqrt(2.0 / 3);
    struct Case {
        const char *show, *view;
        Corner corner;
        double half;
        vec3 expected;
    };
    for (const Case& c :
         {Case{"cad", "front", lowerLeft, 6, {1, 1, 0}}, Case{"cad", "top", upperLeft, 6, {1, 0, 1}},
          Case{"cad", "side", lowerRight, 6, {0, 1, 1}}, Case{"axonometric", "isometric", upperLeft, 7.2, vec3(third)},
          Case{"axonometric", "dimetric", upperRight, 7.2, vec3(2, 2, 1) * std::sqrt(2.0) / 3.0},
          Case{"oblique", "cavalier", upperLeft, 8, vec3(1)}, Case{"oblique", "cabinet", upperRight, 8, {1, 1, 0.5}},
          Case{"oblique", "planometric", lowerLeft, 8.5, vec3(1)}}) {
        SCOPED_TRACE(c.view);
        const Picture pane = paneOf(run.set("show", c.show).picture(), c.corner);
        const mat4 m = run.matrix(std::string(c.view) + "FromWorld");
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(length(m, unit(axis), c.half), c.expected[axis], 1e-13);
            const vec2 from = pixelOf(m, wallCorner(4)), to = pixelOf(m, wallCorner(4) + 2.0 * unit(axis));
            const vec2 along = glm::normalize(to - from);
            // From its one end to the other an arrow has its colour, but for pixels at the beginning, where a later arrow
            // may be over it, and for the tip, which is two pixels wide three pixels before its end. Its letter alone has
            // it elsewhere: it begins 4 pixels beyond the tip, so that an arrow that is too long would still be seen.
            double first = 1e9, last = -1e9;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    if (!sameColor(pane.at(x, y), axisColors[axis])) continue;
                    ASSERT_GT(c.expected[axis], 0) << "seen end on, there is nothing to draw";
                    const vec2 pixel = vec2(x + 0.5, height - y - 0.5) - from;
                    const double aside = along.x * pixel.y - along.y * pixel.x, at = glm::dot(along, pixel);
                    if (at > glm::length(to - from) + 4 && glm::length(pixel - (to - from)) < 18) continue;
                    EXPECT_LT(std::abs(aside), 4) << x << ", " << y;
                    first = std::min(first, at);
                    last = std::max(last, at);
                }
            }
            if (c.expected[axis] == 0) continue;
            const double metre = height / (2 * c.half);
            EXPECT_NEAR(last, 2 * metre * c.expected[axis] - 2, 2.5);
            EXPECT_NEAR(first, 2, 3);
        }
    }
}

TEST(ProjectionsFull, squares_sum_to_two) {
    DemoRun run("projections");
    run.set("show", "axonometric");
    for (const double turn : {-350.0, -77.7, 0.0, 12.5, 45.0, 200.0}) {
        for (const double tilt : {-90.0, -33.3, 0.0, 1e-6, 35.264, 90.0}) {
            run.set("turn", turn).set("tilt", tilt).picture();
            double sum = 0;
            for (const char* name : {"shortening-x", "shortening-y", "shortening-z"}) {
                sum += run.readout(name) * run.readout(name);
            }
            EXPECT_NEAR(sum, 2, 1e-14);  // ten roundings of numbers up to 2
        }
    }
    run.set("show", "oblique").set("length", 1).picture();  // and not in another view
    EXPECT_EQ(run.readout("shortening-z"), 1);
}

TEST(Projections, only_face_on) {
    DemoRun run("projections");
    const vec3 x = unit(0), y = unit(1), z = unit(2);
    run.picture();
    const mat4 front = run.matrix("frontFromWorld");
    run.set("show", "oblique").picture();
    const mat4 cavalier = run.matrix("cavalierFromWorld"), cabinet = run.matrix("cabinetFromWorld"),
               planometric = run.matrix("planometricFromWorld");
    run.set("show", "axonometric").picture();
    const mat4 isometric = run.matrix("isometricFromWorld");

    // The front of the house is parallel to these pictures: every length and angle on it is kept
    for (const auto& [m, half] : {std::pair{front, 6.0}, {cavalier, 8.0}, {cabinet, 8.0}}) {
        for (const vec3& along : {x, y, x + y, 3.0 * x - 2.0 * y}) {
            EXPECT_NEAR(length(m, along, half), glm::length(along), 1e-13);
            EXPECT_NEAR(angle(m, x, along), degrees(std::acos(along.x / glm::length(along))), 1e-11);
        }
    }
    EXPECT_NEAR(angle(planometric, x, z), 90, 1e-11);  // and here the floor is
    EXPECT_NEAR(length(planometric, x + z, 8.5), std::sqrt(2.0), 1e-13);

    // Cavalier keeps a depth, and no angle with it, nor the length of a diagonal
    EXPECT_NEAR(length(cavalier, z, 8), 1, 1e-13);
    EXPECT_NEAR(angle(cavalier, x, -z), 45, 1e-11);
    EXPECT_NEAR(length(cavalier, x - z, 8), 2 * std::cos(radians(22.5)), 1e-13);
    EXPECT_NEAR(length(cabinet, z, 8), 0.5, 1e-13);

    // No face is parallel to the isometric picture: right angles become 60 or 120, and all edges are shorter
    EXPECT_NEAR(angle(isometric, x, z), 120, 1e-11);
    EXPECT_NEAR(angle(isometric, x, -z), 60, 1e-11);
    EXPECT_NEAR(length(isometric, x, 7.2), std::sqrt(2.0 / 3), 1e-13);
    EXPECT_NEAR(length(isometric, x - z, 7.2), std::sqrt(2.0), 1e-13);  // this diagonal happens to be parallel
    EXPECT_NEAR(length(isometric, x + z, 7.2), std::sqrt(2.0 / 3), 1e-13);
}

TEST(Projections, one_two_three) {
    DemoRun run("projections");
    run.set("show", "vanishing");
    struct Case {
        double turn, tilt;
        int points;
    };
    for (const Case& c : {Case{0, 0, 1}, Case{90, 0, 1}, Case{-180, 0, 1}, Case{0, 90, 1}, Case{0, -90, 1},
                          Case{30, 0, 2}, Case{0, 30, 2}, Case{30, 90, 1}, Case{30, 20, 3}, Case{1e-6, 1e-6, 3}}) {
        run.set("turn", c.turn).set("tilt", c.tilt).picture();
        EXPECT_EQ(run.readout("vanishing-points"), c.points) << c.turn << ", " << c.tilt;
    }
    // The three panes before it have what they are named for: an axis has a point where w changes along it.
    for (const auto& [view, points] : {std::pair{"one-point", 1}, {"two-point", 2}, {"three-point", 3}}) {
        const mat4 m = run.matrix(std::string(view) + "FromWorld");
        int count = 0;
        for (int axis = 0; axis < 3; ++axis) count += std::abs(m[axis].w) > 1e-12 ? 1 : 0;
        EXPECT_EQ(count, points) << view;
    }
}

TEST(ProjectionsFull, lines_meet) {
    DemoRun run("projections");
    const Picture picture = run.set("show", "vanishing").picture();
    // Float has 24 bits: 6e-8 of some hundred pixels, a few times over
    EXPECT_LT(run.readout("meeting-error"), 1e-3);
    EXPECT_GT(run.readout("meeting-error"), 0);
    for (const auto& [view, corner] : {std::pair{"one-point", upperLeft},
                                       {"two-point", upperRight},
                                       {"three-point", lowerLeft},
                                       {"yours", lowerRight}}) {
        SCOPED_TRACE(view);
        const mat4 m = run.matrix(std::string(view) + "FromWorld");
        const Picture pane = paneOf(picture, corner);
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(m[axis].w) < 1e-12) {
                EXPECT_EQ(countPixels(pane, axisColors[axis]), 0);
                continue;
            }
            // The place where a point very far along the axis is drawn, towards the side that is before the eye
            const double far = m[axis].w > 0 ? 1e12 : -1e12;
            const vec2 meeting = pixelOf(m, far * unit(axis));
            int count = 0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    if (!sameColor(pane.at(x, y), axisColors[axis])) continue;
                    const vec2 pixel(x + 0.5, height - y - 0.5);
                    if (glm::length(pixel - meeting - vec2(12, 14)) < 20) continue;  // the letter beside the point
                    if (glm::length(pixel - meeting) < 5) continue;                  // and the dot on it
                    ++count;
                    double nearest = std::numeric_limits<double>::infinity();
                    for (int i = 0; i < 8; ++i) {
                        const vec2 from = pixelOf(m, wallCorner(i)), along = glm::normalize(meeting - from);
                        const vec2 to = pixel - from;
                        if (glm::dot(to, along) < -1 || glm::dot(to - meeting + from, along) > 1) continue;
                        nearest = std::min(nearest, std::abs(along.x * to.y - along.y * to.x));
                    }
                    // Half a pixel's diagonal; OpenGL lets a driver set a pixel one unit beside that of its rule, which is half a
                    // unit beside the line.
                    EXPECT_LT(nearest, onLlvmpipe() ? 0.75 : 1.5) << "axis " << axis << " at " << x << ", " << y;
                }
            }
            EXPECT_GT(count, 50) << "axis " << axis;
        }
    }
    // From every side, and from afar
    for (const double turn : {-200, -91, 1, 60, 179}) {
        for (const double tilt : {-89.9, -30.0, 0.001, 45.0}) {
            for (const double distance : {9, 1000}) {
                run.set("turn", turn).set("tilt", tilt).set("distance", distance).picture();
                EXPECT_LT(run.readout("meeting-error"), 1e-2) << turn << ", " << tilt << ", " << distance;
            }
        }
    }
}

TEST(Projections, eye_on_the_horizon) {
    DemoRun run("projections");
    run.set("show", "vanishing");
    for (const double turn : {0, 30, 200}) {
        for (const double tilt : {-15, 0, 25}) {
            const Picture pane = paneOf(run.set("turn", turn).set("tilt", tilt).picture(), lowerRight);
            const mat4 m = run.matrix("yoursFromWorld");
            const double t = radians(turn), b = radians(tilt);
            const vec3 level(std::sin(t), 0, std::cos(t)), right(std::cos(t), 0, -std::sin(t));
            const vec3 eye = middle + 14.0 * (std::cos(b) * level + vec3(0, std::sin(b), 0));
            for (const double ahead : {1.0, 30.0, 1e4}) {
                for (const double aside : {-1.0, 0.0, 0.7}) {
                    const vec2 pixel = pixelOf(m, eye + ahead * (aside * right - level));
                    // The grey line is there, or an edge or a line before it
                    const int x = std::clamp(int(pixel.x), 0, width - 1), y = height - 1 - int(std::floor(pixel.y));
                    ASSERT_TRUE(y > 0 && y < height - 1);
                    bool found = false;
                    for (int up = -1; up <= 1; ++up) found |= !sameColor(pane.at(x, y + up), paper);
                    EXPECT_TRUE(found) << turn << ", " << tilt << ": " << x << ", " << y;
                }
            }
            // And it is one level line from side to side: grey wherever nothing is before it
            const int row = height - 1 - int(std::floor(pixelOf(m, eye - level).y));
            int grey = 0;
            for (int x = 0; x < width; ++x) {
                for (int up = -1; up <= 1; ++up) grey += sameColor(pane.at(x, row + up), {153, 153, 153}) ? 1 : 0;
            }
            EXPECT_GT(grey, width / 4);
        }
    }
}

TEST(Projections, far_eye_is_parallel) {
    DemoRun run("projections");
    run.set("show", "axonometric").picture();
    const mat4 parallel = run.matrix("yoursFromWorld");
    run.set("show", "cad");
    const auto difference = [&](double distance) {
        run.set("distance", distance).picture();
        const mat4 m = run.matrix("perspectiveFromWorld");
        double most = 0;
        for (const fvec3& position : meshOf(house()).positions) {
            // The scales of the two panes are 6 and 7.2 m
            const vec2 centre(width / 2.0, height / 2.0);
            const vec2 expected = (pixelOf(parallel, vec3(position)) - centre) * (7.2 / 6) + centre;
            most = std::max(most, glm::length(pixelOf(m, vec3(position)) - expected));
        }
        return most;
    };
    const double at10 = difference(10), at100 = difference(100), at1000 = difference(1000);
    EXPECT_GT(at10, 50);
    // x d/(d - z) - x = x z/d + x (z/d)^2 ...: with z up to 8 the second term is below a tenth of the first at d = 100
    EXPECT_NEAR(at100 / at1000, 10, 1);
    EXPECT_LT(at1000, 2);
}
