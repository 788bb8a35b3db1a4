#include "mv/math/stereo.h"

#include <array>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support.h"

using namespace mv;
using namespace mv::test;

namespace {

// Two eyes `separation` apart that look along -z in parallel, through one window at the distance `convergence`.
mat4 offAxis(double x, double convergence) {
    FrustumBounds window = frustumBounds(60, 1, 0.1, 100);
    window.left -= x * 0.1 / convergence;
    window.right -= x * 0.1 / convergence;
    return frustum(window) * translate(-x, 0, 0);
}

TEST(Parallax, IsOfTheDistanceAlone) {
    const double separation = 0.06, convergence = 2, focal = 240 / std::tan(radians(30.0));  // 480 rows
    for (const double distance : {0.5, 1.0, 2.0, 4.0, 50.0}) {
        const vec3 points[] = {{0, 0, -distance}, {0.2, -0.1, -distance}};
        const auto parallax = parallaxOf(points, offAxis(-separation / 2, convergence),
                                         offAxis(separation / 2, convergence), 480, 480, 0.1);
        ASSERT_TRUE(parallax);
        // Similar triangles tell it; a few roundings of numbers up to 480.
        const double expected = focal * separation * (1 / convergence - 1 / distance);
        EXPECT_NEAR(parallax->leastAcross, expected, 1e-12);
        EXPECT_NEAR(parallax->mostAcross, expected, 1e-12);
        EXPECT_NEAR(parallax->vertical, 0, 1e-12);
    }
}

// X39: eyes turned towards each other see the corners of the picture at different heights, the more the nearer they
// meet; eyes in parallel see none. 480 rows of a picture 4:3, 60 degrees high, eyes 0.06 apart, a point in the corner.
TEST(ParallaxExtremes, X39ToeInGivesVerticalParallaxOffAxisNone) {
    const double half = std::tan(radians(30.0));
    double toedBefore = HUGE_VAL;
    for (const auto& row : {std::pair{0.5, 22.0}, {1.0, 11.0}, {3.0, 3.6}, {10.0, 1.1}}) {
        const double convergence = row.first, expected = row.second;
        const vec3 corner[] = {vec3(half * 4 / 3, half, -1) * convergence};
        const mat4 lens = perspective(60, 4.0 / 3, 0.1, 100);
        const auto eye = [&](double x) { return lens * lookAt({x, 0, 0}, {0, 0, -convergence}, {0, 1, 0}); };
        const double toed = parallaxOf(corner, eye(-0.03), eye(0.03), 640, 480, 0.1)->vertical;
        EXPECT_NEAR(toed, expected, 0.03 * expected);  // figures of two digits, measured elsewhere
        EXPECT_LT(toed, toedBefore);
        toedBefore = toed;
        const double level =
            parallaxOf(corner, offAxis(-0.03, convergence), offAxis(0.03, convergence), 640, 480, 0.1)->vertical;
        EXPECT_LT(level, 1e-12);
    }
}

TEST(Parallax, PassesOverWhatIsNotBeforeBothEyes) {
    const vec3 points[] = {{0, 0, 1}, {0, 0, -0.05}};
    EXPECT_FALSE(parallaxOf(points, offAxis(-0.03, 2), offAxis(0.03, 2), 480, 480, 0.1));
    EXPECT_EQ(refusal([&] { parallaxOf(points, mat4(1), mat4(1), 480, 480, 0); }),
              "parallaxOf: leastW must be greater than 0 and finite, 0");
}

}  // namespace
