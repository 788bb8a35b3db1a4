#include "mirror/mirrors.h"

#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "../math/support.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

const Mirror first{{0, 0, -2}, {1, 0, 0}, {0, 1, 0}};   // faces +z
const Mirror second{{0, 0, 3}, {-1, 0, 0}, {0, 1, 0}};  // faces -z
const std::array<Mirror, 2> both{first, second};
const mat4 projection = perspective(60, 1, 0.1, 200);

mat4 clipFrom(const vec3& eye, const vec3& at = vec3(0, 0, -2)) { return projection * lookAt(eye, at, vec3(0, 1, 0)); }

}  // namespace

TEST(Mirrors, face_where_right_and_up_say) {
    EXPECT_EQ(first.plane(), vec4(0, 0, 1, 2));
    EXPECT_EQ(second.plane(), vec4(0, 0, -1, 3));
    for (const Mirror& mirror : both) {
        const auto corners = mirror.corners();
        const vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[1]);
        EXPECT_GT(glm::dot(normal, vec3(mirror.plane())), 0);
        for (const vec3& corner : corners) EXPECT_EQ(glm::dot(mirror.plane(), vec4(corner, 1)), 0);
    }
}

TEST(Mirrors, show_each_other_farther_and_farther_away) {
    const auto chains = mirrorChains(both, clipFrom({0.2, 0.3, 2}), 9);
    ASSERT_EQ(chains.size(), 1U);  // the second one is behind the eye
    ASSERT_EQ(chains[0].size(), 9U);
    for (std::size_t i = 0; i < 9; ++i) {
        const SeenMirror& seen = chains[0][i];
        EXPECT_EQ(seen.which, i % 2);
        // The mirrors are 5 apart, so each reflection is 5 farther away.
        const vec4 middle = seen.worldFromMirror * vec4(both.at(i % 2).middle, 1);
        EXPECT_LT(glm::length(vec3(middle) - vec3(0, 0, -2 - 5.0 * double(i))), 1e-12);
        EXPECT_NEAR(glm::determinant(mat3(seen.worldFromShown)), i % 2 == 0 ? -1 : 1, 1e-12);
        // A point in front of the mirror appears behind it.
        const vec4 shown = seen.worldFromShown * vec4(0, 0, 1, 1);
        EXPECT_LT(shown.z, middle.z);
        // The seen part of it lies within the seen part of the one before.
        if (i > 0) {
            EXPECT_FALSE(areBeyond(seen.outline, chains[0][i - 1].edges));
        }
    }
    EXPECT_EQ(mirrorChains({&first, 1}, clipFrom({0.2, 0.3, 2}), 9).front().size(), 1U);  // none is seen in itself
}

TEST(Mirrors, show_nothing_to_an_eye_that_is_not_before_them) {
    for (const vec3& eye : {vec3(2, 0.5, -2), vec3(2, 0, -2 + 1e-9), vec3(0.3, 0, -4)})
        EXPECT_TRUE(mirrorChains({&first, 1}, clipFrom(eye), 9).empty());
    EXPECT_TRUE(mirrorChains({&first, 1}, clipFrom({0, 0, 2}, {0, 0, 5}), 9).empty()) << "behind the eye's back";
    EXPECT_FALSE(mirrorChains({&first, 1}, clipFrom({1.5, 0, -1.9}), 9).empty());
    const std::array<Mirror, 3> three{first, second, first};
    EXPECT_EQ(refusal([&] {
                  mirrorChains(three, clipFrom({0, 0, 2}), 1);
              }),
              "mirrorChains: must be given two mirrors at most, 3");
}

// No point that is seen through the mirror is left out by its edges, and one beside them is.
TEST(Mirrors, bound_what_they_show) {
    Random random(30);
    const vec3 eye(0.4, 0.2, 1.5);
    const mat4 clipFromWorld = clipFrom(eye);
    const SeenMirror seen = mirrorChains({&first, 1}, clipFromWorld, 1).front().front();
    int through = 0, beside = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 point(random.number(-4, 4), random.number(-4, 4), random.number(-1.9, 6));
        const vec3 image(seen.worldFromShown * vec4(point, 1));
        const vec3 hit = glm::mix(eye, image, (eye.z + 2) / (eye.z - image.z));
        const vec4 clip = clipFromWorld * vec4(image, 1);
        const double edge = std::max(std::abs(hit.x), std::abs(hit.y)) - 1;
        if (std::abs(edge) < 1e-6) continue;
        EXPECT_EQ(areBeyond({&clip, 1}, seen.edges), edge > 0) << point.x << ", " << point.y << ", " << point.z;
        ++(edge > 0 ? beside : through);
    }
    EXPECT_GT(through, 100);
    EXPECT_GT(beside, 100);
}

TEST(Mirrors, lay_the_near_plane_where_it_is_asked) {
    Random random(31);
    for (int i = 0; i < 100; ++i) {
        const vec3 normal = glm::normalize(vec3(random.number(-1, 1), random.number(-1, 1), -1));
        const vec4 plane(normal, -random.number(0.1, 5));
        const mat4 oblique = withNearPlane(projection, plane);
        for (int k = 0; k < 50; ++k) {
            // A point of the view volume
            const vec4 far =
                glm::inverse(projection) * vec4(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1), 1);
            const vec4 point(vec3(far) / far.w, 1);
            const vec4 clip = oblique * point, before = projection * point;
            EXPECT_EQ(clip.x, before.x);
            EXPECT_EQ(clip.y, before.y);
            EXPECT_EQ(clip.w, before.w);
            // In front of the plane it is seen, behind it is not; a rounding of numbers up to 200 either way.
            const double side = glm::dot(plane, point);
            if (side > 1e-9) {
                EXPECT_TRUE(clip.z >= -clip.w && clip.z <= clip.w * (1 + 1e-12));
            } else if (side < -1e-9) {
                EXPECT_LT(clip.z, -clip.w);
            }
        }
    }
    EXPECT_EQ(refusal([] {
                  withNearPlane(projection, {0, 0, -1, 0});
              }),
              "withNearPlane: must be given a plane with the eye behind it, 0");
}

TEST(Mirrors, take_planes_between_spaces) {
    const mat4 worldFromOther = translate(1, 2, 3) * rotateY(30);
    const vec4 plane(0, 0.6, 0.8, -1);
    const vec4 point(0.3, -0.2, 0.9, 1);
    EXPECT_NEAR(glm::dot(planeIn(worldFromOther, plane), point), glm::dot(plane, worldFromOther * point), 1e-15);
}
