#include "mv/geometry/in_volume.h"

#include <vector>

#include "math/support.h"
#include "mv/geometry/bounds.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

const auto planes = perspectivePlanes(60, 1.5, 1, 50);
const mat4 clip = perspective(60, 1.5, 1, 50);

bool holds(const vec3& point) {
    const vec4 p = clip * vec4(point, 1);
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= p.w;
}

}  // namespace

// Points of the bodies tell: of a body outside none is in the volume, of a body inside all are.
TEST(InVolume, no_point_says_otherwise) {
    Random random(1);
    int seen[3] = {0, 0, 0};
    for (int i = 0; i < 3000; ++i) {
        const vec3 center = vec3(0, 0, -25) + random.point(40);
        const double radius = random.logarithmic(0.1, 20);
        Bounds bounds;
        bounds.add(center - radius);
        bounds.add(center + radius * vec3(1, 0.2, 0.6));
        const InVolume ball = ballInVolume(center, radius, planes), box = hullInVolume(bounds.corners(), planes);
        ++seen[static_cast<int>(ball)];
        for (int k = 0; k < 60; ++k) {
            const vec3 inBall = center + radius * 0.999999 * random.direction();
            const vec3 inBox = glm::mix(bounds.low, bounds.high, (random.point(1) + 1.0) / 2.0);
            if (ball == InVolume::outside) {
                EXPECT_FALSE(holds(inBall));
            }
            if (ball == InVolume::inside) {
                EXPECT_TRUE(holds(inBall));
            }
            if (box == InVolume::outside) {
                EXPECT_FALSE(holds(inBox));
            }
            if (box == InVolume::inside) {
                EXPECT_TRUE(holds(inBox));
            }
        }
        // A ball round a box is no more outside than the box
        const double round = glm::distance(bounds.low, bounds.high) / 2 * (1 + 1e-15);
        if (ballInVolume(bounds.middle(), round, planes) == InVolume::outside) {
            EXPECT_EQ(box, InVolume::outside);
        }
    }
    for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(InVolume, touching_is_crossing) {
    const std::vector<vec4> floor{vec4(0, 1, 0, 0)};
    EXPECT_EQ(ballInVolume({0, 2, 0}, 2, floor), InVolume::inside);
    EXPECT_EQ(ballInVolume({0, 1.999, 0}, 2, floor), InVolume::crossing);
    EXPECT_EQ(ballInVolume({0, -2, 0}, 2, floor), InVolume::crossing);
    EXPECT_EQ(ballInVolume({0, -2.001, 0}, 2, floor), InVolume::outside);
    EXPECT_EQ(ballInVolume({0, 0, 0}, 0, floor), InVolume::inside);
    const std::vector<vec3> segment{vec3(0, 0, 0), vec3(0, -1, 0)};
    EXPECT_EQ(hullInVolume(segment, floor), InVolume::crossing);
    EXPECT_EQ(hullInVolume(std::vector<vec3>{}, floor), InVolume::outside);
}

TEST(InVolume, a_plane_without_normal_leaves_nothing_out) {
    const std::vector<vec4> none{vec4(0), vec4(0, 0, 0, -1)};
    EXPECT_EQ(ballInVolume({3, 4, 5}, 1, none), InVolume::inside);
    EXPECT_NE(hullInVolume(std::vector{vec3(3, 4, 5)}, none), InVolume::outside);
    EXPECT_EQ(refusal([] { ballInVolume({0, 0, 0}, -1, {}); }), "ballInVolume: the radius must be 0 or more, -1");
    EXPECT_EQ(refusal([] {
                  ballInVolume({0, notANumber, 0}, 1, {});
              }),
              "ballInVolume: the center must be finite, (0, nan, 0)");
    EXPECT_EQ(refusal([] { hullInVolume(std::vector{vec3(infinite, 0, 0)}, {}); }),
              "hullInVolume: a corner must be finite, (inf, 0, 0)");
}
