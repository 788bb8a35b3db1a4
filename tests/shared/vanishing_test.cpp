#include "projections/vanishing.h"

#include <glm/geometric.hpp>

#include "../math/support.h"
#include "mv/geometry/check.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

const mat4 perspectiveView = infinitePerspective(60, 1.5, 0.1) * lookAt({3, 4, 5}, {0, 1, 0}, {0, 1, 0});

TEST(Vanishing, PointIsWhereFarPointsAreDrawn) {
    for (const vec3& direction : {vec3(-1, 0, 0), vec3(0, -1, 0), vec3(0, 0, -1), vec3(-1, -2, -0.5)}) {
        const auto point = vanishingPoint(perspectiveView, direction, 600, 400);
        ASSERT_TRUE(point);
        for (const vec3& from : {vec3(0), vec3(1, 0, -2)}) {
            const vec4 far = perspectiveView * vec4(from + 1e9 * direction, 1);
            // 3 units of offset at 1e9 units of distance, in pictures of up to some thousand pixels
            EXPECT_LT(glm::length(pixelFromNdc(ndcFromClip(far), 600, 400) - *point), 1e-4);
        }
        // The lines run away from the same point in the opposite direction, whatever the length
        EXPECT_LT(glm::length(*vanishingPoint(perspectiveView, -1e-200 * direction, 600, 400) - *point), 1e-10);
    }
}

TEST(Vanishing, ThereIsNoneParallelToThePicture) {
    EXPECT_FALSE(vanishingPoint(ortho(-1, 1, -1, 1, -1, 1) * rotateX(20), {0, 0, 1}, 10, 10));
    const mat4 level = infinitePerspective(60, 1, 0.1) * rotateY(90);
    EXPECT_FALSE(vanishingPoint(level, {0, 1, 0}, 10, 10));
    EXPECT_FALSE(vanishingPoint(level, {0, 0, 1}, 10, 10));
    EXPECT_TRUE(vanishingPoint(level, {1, 0, 0}, 10, 10));
    EXPECT_TRUE(vanishingPoint(infinitePerspective(60, 1, 0.1) * rotateX(1e-9), {0, 1, 0}, 10, 10));
}

TEST(Vanishing, MissIsTheDistanceFromTheLine) {
    const vec3 direction(-1, 0, 0);
    const std::array<vec3, 2> edge{vec3(1, 2, 0), vec3(-3, 2, 0)};
    const vec2 point = *vanishingPoint(perspectiveView, direction, 600, 400);
    EXPECT_LT(missOfVanishingPoint(point, edge, perspectiveView, 600, 400), 1e-3);  // float, of 600 pixels
    EXPECT_GT(missOfVanishingPoint(point + vec2(0, 50), edge, perspectiveView, 600, 400), 1);
    // Seen by an eye on its own line the edge is a point: it is where it should be
    const mat4 along = infinitePerspective(60, 1, 0.1) * translate(0, 0, -5);
    const vec2 centre(50, 50);
    EXPECT_EQ(missOfVanishingPoint(centre, {vec3(0, 0, 1), vec3(0, 0, -1)}, along, 100, 100), 0);
}

TEST(Vanishing, LinesEndInDirections) {
    const std::array<vec3, 2> points{vec3(1, 2, 3), vec3(4, 5, 6)};
    const MeshData lines = linesToInfinity(points);
    validate(lines);
    ASSERT_EQ(lines.positions.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) {
        fvec3 direction(0);
        direction[int(i / 4)] = 1;
        EXPECT_EQ(lines.texCoords[i].x, float(i % 2));
        EXPECT_EQ(lines.positions[i], i % 2 == 1 ? direction : fvec3(points[i / 2 % 2]));
    }
    const MeshData horizon = horizonLines();
    validate(horizon);
    EXPECT_EQ(horizon.positions.front(), horizon.positions.back());  // all round
    for (const fvec3& direction : horizon.positions) EXPECT_EQ(direction.y, 0);
}

TEST(Vanishing, RefusesPointsThatNoFloatHolds) {
    // One after the other, in the same loop: no one's being fine makes the next one so
    for (const double far : {1e38, 1e39, infinite, notANumber}) {
        const std::array<vec3, 2> points{vec3(1, 2, 3), vec3(0, -far, 0)};
        const std::string said = refusal([&] { linesToInfinity(points); });
        EXPECT_EQ(said.rfind("linesToInfinity: a point must fit into floats, (0, ", 0) == 0, far != 1e38) << said;
    }
}

TEST(Vanishing, RefusesWhatIsNoDirection) {
    EXPECT_EQ(refusal([] { vanishingPoint(perspectiveView, vec3(0), 10, 10); }),
              "vanishingPoint: the direction must not be 0");
    EXPECT_NE(refusal([] { vanishingPoint(perspectiveView, vec3(notANumber), 10, 10); }), "");
    EXPECT_NE(refusal([] { linesToInfinity(std::array{vec3(0, notANumber, 0)}); }), "");
    // Behind the eye
    EXPECT_NE(refusal([] { missOfVanishingPoint({}, {vec3(0), vec3(9, 9, 9)}, perspectiveView, 10, 10); }), "");
}

}  // namespace
