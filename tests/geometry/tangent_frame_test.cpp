#include "mv/geometry/tangent_frame.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "mv/error.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

using Corners = std::array<vec3, 3>;
using Coords = std::array<vec2, 3>;

void expectFrame(const TangentFrame& frame) {
    const mat3 m(frame.tangent, frame.bitangent, frame.normal), product = glm::transpose(m) * m;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 1e-15 * 4);
    }
    EXPECT_NEAR(glm::determinant(m), frame.sign, 1e-14);
}

const Corners right{vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)};

}  // namespace

TEST(TangentFrame, u_grows_along_the_tangent_and_v_stays) {
    Random random(49);
    const auto number = [&] { return random.number(-1, 1); };
    for (int i = 0; i < 1000; ++i) {
        Corners p;
        Coords t;
        for (vec3& point : p) point = vec3(number(), number(), number());
        for (vec2& coord : t) coord = vec2(number(), number());
        const TangentFrame frame = tangentFrame(p, t);
        expectFrame(frame);
        // (tangent's u and v) by the affine map of the triangle
        const mat3 basis(p[1] - p[0], p[2] - p[0], frame.normal);
        const vec3 parts = glm::inverse(basis) * frame.tangent;
        const vec2 change = parts.x * (t[1] - t[0]) + parts.y * (t[2] - t[0]);
        EXPECT_GT(change.x, 0);
        EXPECT_LT(std::abs(change.y), 1e-9 * std::max(1.0, change.x) + 1e-9);
    }
}

TEST(TangentFrame, mirrored_and_collapsed) {
    EXPECT_EQ(tangentFrame(right, {vec2(0, 0), vec2(1, 0), vec2(0, 1)}).sign, 1);
    const TangentFrame mirrored = tangentFrame(right, {vec2(0, 0), vec2(-1, 0), vec2(0, 1)});
    EXPECT_EQ(mirrored.sign, -1);
    EXPECT_EQ(mirrored.tangent, vec3(-1, 0, 0));
    EXPECT_EQ(mirrored.bitangent, vec3(0, 1, 0));
    expectFrame(tangentFrame(right, {vec2(0.5), vec2(0.5), vec2(0.5)}));
    // On a line along v, u grows nowhere; on one along u, it grows across the corners with the same u.
    expectFrame(tangentFrame(right, {vec2(0.5, 0), vec2(0.5, 1), vec2(0.5, 2)}));
    const TangentFrame line = tangentFrame(right, {vec2(0, 0), vec2(1, 0), vec2(1, 0)});
    expectFrame(line);
    EXPECT_LT(glm::distance(line.tangent, glm::normalize(vec3(1, 1, 0))), 1e-15);
}

TEST(TangentFrame, refuses) {
    const Coords t{vec2(0, 0), vec2(1, 0), vec2(0, 1)};
    EXPECT_THROW((void)tangentFrame({vec3(0), vec3(1), vec3(2)}, t), Error);
    EXPECT_THROW((void)tangentFrame({vec3(0), vec3(1, 0, 0), vec3(0, std::numeric_limits<double>::infinity(), 0)}, t),
                 Error);
}

TEST(TangentFrame, normals_that_cancel_give_the_face) {
    const vec3 up(0, 1, 0), x(1, 0, 0);
    EXPECT_EQ(shadingNormal({x, -x, up}, {0.5, 0.5, 0}, up), up);
    EXPECT_EQ(shadingNormal({x, -x, up}, {0.5, 0.25, 0}, up), x);
    EXPECT_NEAR(glm::length(shadingNormal({x, up, up}, {0.2, 0.5, 0.3}, up)), 1, 1e-15);
}

TEST(TangentFrame, repeated_coordinates) {
    for (const double whole : {0.0, 1e6, 1e7, -1e7}) EXPECT_NEAR(repeatedCoordinate(whole + 0.3), 0.3, 4e-9 + 3e-8);
    EXPECT_EQ(repeatedCoordinate(-1e-30), 0);
    EXPECT_EQ(repeatedCoordinate(3), 0);
    EXPECT_THROW((void)repeatedCoordinate(std::numeric_limits<double>::quiet_NaN()), Error);
}
