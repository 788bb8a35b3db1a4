#include "texture-map/perspective_quad.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "mv/error.h"

using namespace mv;

namespace {

constexpr Pane pane{10, 20, 300, 200};

// The slip at one place of a triangle of the picture, from its corners' places and w's: the definition.
double slipAt(const vec2* places, const double* w, const vec3& weights) {
    const vec3 heavy(weights.x * w[0], weights.y * w[1], weights.z * w[2]);
    const vec2 shown = weights.x * places[0] + weights.y * places[1] + weights.z * places[2];
    const vec2 right =
        (heavy.x * places[0] + heavy.y * places[1] + heavy.z * places[2]) / (heavy.x + heavy.y + heavy.z);
    return glm::distance(shown, right);
}

}  // namespace

TEST(PerspectiveQuad, corners_have_their_w_and_edges_their_heights) {
    for (const double ratio : {1.0, 2.5, 20.0}) {
        const mat4 clip = clipFromQuad(ratio);
        for (const double u : {0.0, 0.3, 1.0}) {
            EXPECT_DOUBLE_EQ((clip * vec4(u, 0, 0, 1)).w, 1);
            EXPECT_DOUBLE_EQ((clip * vec4(u, 1, 0, 1)).w, ratio);
            EXPECT_NEAR(projected(pixelFromQuad(ratio, pane), {u, 1}).y, 20 + 200 * 0.875, 1e-9);
            EXPECT_NEAR(projected(pixelFromQuad(ratio, pane), {u, 0}).y, 20 + 200 * 0.075, 1e-9);
        }
        const vec2 there = projected(pixelFromQuad(ratio, pane), {0.7, 0.4});
        EXPECT_LT(glm::distance(projected(quadFromPixel(ratio, pane), there), vec2(0.7, 0.4)), 1e-12);
    }
}

TEST(PerspectiveQuad, largest_slip_is_not_exceeded_anywhere) {
    for (const double ratio : {1.3, 4.0, 20.0}) {
        for (const int n : {1, 2, 5}) {
            const mat3 pixels = pixelFromQuad(ratio, pane);
            double most = 0;
            for (int cell = 0; cell < n * n; ++cell) {
                const vec2 low = vec2(cell % n, cell / n) / double(n);  // NOLINT(bugprone-integer-division)
                for (const vec2& third : {vec2(1, 0), vec2(0, 1)}) {
                    const vec2 uv[3] = {low, low + vec2(1.0 / n), low + third / double(n)};
                    vec2 places[3];
                    double w[3];
                    for (int i = 0; i < 3; ++i) {
                        places[i] = projected(pixels, uv[i]);
                        w[i] = 1 + (ratio - 1) * uv[i].y;
                    }
                    for (int i = 0; i <= 60; ++i) {
                        for (int j = 0; i + j <= 60; ++j)
                            most = std::max(most, slipAt(places, w, vec3(i, j, 60 - i - j) / 60.0));
                    }
                }
            }
            const Slip slip = largestSlip(ratio, n, pane);
            EXPECT_LE(most, slip.pixels * (1 + 1e-12));
            EXPECT_GE(most, slip.pixels * 0.995);  // of 60 places along an edge one is near the highest, which is level
            EXPECT_NEAR(glm::distance(slip.shown, slip.right), slip.pixels, 1e-9);
        }
    }
    EXPECT_EQ(largestSlip(1, 3, pane).pixels, 0);
}

TEST(PerspectiveQuad, refuses) {
    EXPECT_THROW((void)largestSlip(2, 0, pane), Error);
    EXPECT_THROW((void)largestSlip(0.5, 1, pane), Error);
    EXPECT_THROW((void)largestSlip(std::numeric_limits<double>::quiet_NaN(), 1, pane), Error);
}
