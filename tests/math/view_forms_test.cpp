// depth_range.h, shear.h, unproject.h and reflect.h.
#include <glm/gtc/matrix_transform.hpp>

#include "math/support.h"
#include "mv/math/depth_range.h"
#include "mv/math/projection.h"
#include "mv/math/reflect.h"
#include "mv/math/shear.h"
#include "mv/math/transform.h"
#include "mv/math/unproject.h"

using namespace mv;
using namespace mv::test;

namespace {

double depthAt(const mat4& m, double z) {
    const vec4 clip = m * vec4(0, 0, z, 1);
    return clip.z / clip.w;
}

constexpr DepthRange ranges[] = {DepthRange::zeroToOne, DepthRange::oneToZero, DepthRange::oneToMinusOne};
constexpr double atNear[] = {0, 1, 1}, atFar[] = {1, 0, -1};

}  // namespace

TEST(DepthRange, ends_are_where_they_are_said_to_be) {
    for (int i = 0; i < 3; ++i) {
        for (const double far : {2.0, 100.0, 1e6}) {
            const mat4 lens = perspective(50, 1.5, 0.5, far, ranges[i]), box = ortho(-1, 2, -3, 4, 0.5, far, ranges[i]);
            // Roundings of the largest depth, 1
            EXPECT_NEAR(depthAt(lens, -0.5), atNear[i], 4e-16);
            EXPECT_NEAR(depthAt(lens, -far), atFar[i], 4e-16);
            EXPECT_NEAR(depthAt(box, -0.5), atNear[i], 4e-16);
            EXPECT_NEAR(depthAt(box, -far), atFar[i], 4e-16);
        }
        // At infinity: exactly so, since w is z there
        EXPECT_EQ(depthAt(perspective(50, 1.5, 0.5, infinite, ranges[i]), -0.5), atNear[i]);
        const vec4 sky = perspective(50, 1.5, 0.5, infinite, ranges[i]) * vec4(0, 0, -1, 0);
        EXPECT_EQ(sky.z / sky.w, atFar[i]);
    }
}

TEST(DepthRange, only_the_third_row_differs) {
    for (const DepthRange range : ranges) {
        mat4 lens = perspective(40, 0.8, 1, 9, range), box = ortho(-1, 2, -3, 4, 1, 9, range);
        for (mat4* m : {&lens, &box}) {
            const mat4 usual = m == &lens ? perspective(40, 0.8, 1, 9) : ortho(-1, 2, -3, 4, 1, 9);
            (*m)[2][2] = usual[2][2];
            (*m)[3][2] = usual[3][2];
            EXPECT_EQ(*m, usual);
        }
    }
    EXPECT_LT(largestDifference(perspective(40, 0.8, 1, 9, DepthRange::zeroToOne),
                                glm::perspectiveRH_ZO(radians(40), 0.8, 1.0, 9.0)),
              1e-14);
    EXPECT_LT(largestDifference(perspective(40, 0.8, 1, 9, DepthRange::oneToZero),
                                glm::perspectiveRH_ZO(radians(40), 0.8, 9.0, 1.0)),
              1e-14);
    EXPECT_LT(largestDifference(ortho(-1, 2, -3, 4, 1, 9, DepthRange::zeroToOne),
                                glm::orthoRH_ZO(-1.0, 2.0, -3.0, 4.0, 1.0, 9.0)),
              1e-15);
}

TEST(DepthRange, a_reversed_one_tells_distances_apart_in_float) {
    // Distances a millionth of themselves apart, up to far/near = 1e6
    const fmat4 clip(perspective(50, 1, 0.1, 1e5, DepthRange::oneToZero));
    for (double z = 0.2; z < 9e4; z *= 1.3) {
        const auto depth = [&](double at) {
            const fvec4 p = clip * fvec4(0, 0, static_cast<float>(-at), 1);
            return p.z / p.w;
        };
        EXPECT_GT(depth(z), depth(z * (1 + 1e-6))) << z;
    }
}

TEST(DepthRange, refuses_what_the_usual_ones_refuse) {
    EXPECT_EQ(refusal([] { perspective(50, 1, 2, 1, DepthRange::oneToZero); }),
              refusal([] { perspective(50, 1, 2, 1); }));
    EXPECT_EQ(refusal([] { perspective(50, 1, 0, infinite, DepthRange::zeroToOne); }),
              refusal([] { infinitePerspective(50, 1, 0); }));
    EXPECT_EQ(refusal([] { ortho(-1, 1, -1, 1, 3, 3, DepthRange::zeroToOne); }),
              refusal([] { ortho(-1, 1, -1, 1, 3, 3); }));
}

TEST(InfiniteFrustum, is_the_limit_of_frustum_and_the_symmetric_one) {
    EXPECT_LT(largestDifference(infiniteFrustum(-1, 2, -3, 0.5, 0.25), frustum(-1, 2, -3, 0.5, 0.25, 1e18)), 1e-16);
    const double top = 0.25 * std::tan(radians(25));
    EXPECT_LT(
        largestDifference(infiniteFrustum(-1.5 * top, 1.5 * top, -top, top, 0.25), infinitePerspective(50, 1.5, 0.25)),
        1e-15);
    const vec4 sky = infiniteFrustum(-1, 2, -3, 0.5, 0.25) * vec4(3, -2, -7, 0);
    EXPECT_EQ(sky.z, sky.w);
    EXPECT_EQ(refusal([] { infiniteFrustum(1, 1, 0, 1, 1); }), "infiniteFrustum: left and right must differ, 1");
    EXPECT_EQ(refusal([] { infiniteFrustum(0, 1, 2, 2, 1); }), "infiniteFrustum: bottom and top must differ, 2");
    EXPECT_EQ(refusal([] { infiniteFrustum(0, 1, 0, 1, 0); }),
              "infiniteFrustum: near must be greater than 0 and finite, 0");
    EXPECT_EQ(refusal([] { infiniteFrustum(0, infinite, 0, 1, 1); }).rfind("infiniteFrustum: the window's high", 0),
              0U);
    EXPECT_NE(refusal([] { infiniteFrustum(-1e308, 1e308, 0, 1, 1); }).find("overflows"), std::string::npos);
}

TEST(Shear, moves_by_one_coordinate_and_keeps_volumes) {
    EXPECT_EQ(shearX(2, 3) * vec4(5, 7, 11, 1), vec4(5, 17, 26, 1));
    EXPECT_EQ(shearY(2, 3) * vec4(5, 7, 11, 1), vec4(19, 7, 32, 1));
    EXPECT_EQ(shearZ(2, 3) * vec4(5, 7, 11, 1), vec4(27, 40, 11, 1));
    EXPECT_EQ(shearZ(2, 3) * vec4(0, 0, 1, 0), vec4(2, 3, 1, 0));
    for (const mat4& m : {shearX(2, -3), shearY(0.5, 4), shearZ(-1, 7)}) EXPECT_EQ(glm::determinant(m), 1);
    EXPECT_EQ(shearX(2, 3) * shearX(-2, -3), mat4(1));
    // Three of them turn (Paeth 1986), as the page of rasterizer has it: each of an entry's three roundings is of 1 at most.
    for (const double angle : {-100.0, 30.0, 77.0}) {
        const double half = -std::tan(radians(angle) / 2);
        const mat4 turn = shearY(half, 0) * shearX(std::sin(radians(angle)), 0) * shearY(half, 0);
        for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(turn[i], rotate(angle, vec3(0, 0, 1))[i]), 2e-15) << angle;
    }
    EXPECT_EQ(refusal([] { shearY(1, infinite); }), "shearY: the factors must be finite, (1, 0, inf)");
}

TEST(UnProject, comes_back_from_every_pixel) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const double near = random.logarithmic(1e-3, 10), far = near * random.logarithmic(2, 1e6);
        const mat4 view = lookAtAnyRoll(random.point(10), random.point(10));
        const mat4 clip =
            (i % 2 == 0 ? perspective(random.number(10, 120), 1.5, near, far) : ortho(-20, 20, -10, 30, near, far)) *
            view;
        const vec2 pixel(random.number(0, 640), random.number(0, 480));
        const double depth = random.number(0, 1);
        const vec3 point = unProject(pixel, depth, clip, 640, 480);
        const vec4 back = clip * vec4(point, 1);
        // Roundings of coordinates: up to 30 of the eye's, which a perspective divides by near at the least; a parallel view has
        // points as far as `far`, and its depths are parts of far - near
        const double size = i % 2 == 0 ? 30 / std::min(near, 1.0) : 30 + far;
        EXPECT_LT(glm::distance(pixelFromNdc(vec2(back) / back.w, 640, 480), pixel), 4e-13 * size) << i;
        EXPECT_NEAR((back.z / back.w + 1) / 2, depth, 1e-15 * size / std::min(far - near, 1.0)) << i;
    }
}

TEST(UnProject, takes_other_ranges_as_their_header_says) {
    for (const DepthRange range : {DepthRange::zeroToOne, DepthRange::oneToZero}) {
        const mat4 clip = perspective(50, 1.5, 0.5, 50, range);
        for (const double z : {0.5, 1.0, 7.0, 50.0}) {
            const vec4 drawn = clip * vec4(0.1, -0.2, -z, 1);
            const vec2 pixel = (vec2(drawn) / drawn.w + 1.0) * vec2(30, 20);
            const vec3 back = unProject(pixel, (1 + drawn.z / drawn.w) / 2, clip, 60, 40);
            // Some times 1e-16 far/near of the distance: by the way back, and by the rounding of the depth that is given
            EXPECT_LE(glm::distance(back, vec3(0.1, -0.2, -z)), 8 * 1e-16 * 100 * z) << z;
        }
    }
}

TEST(UnProject, corners_of_the_view_volume) {
    const mat4 clip = perspective(50, 1.5, 0.1, 1e6) * lookAt(vec3(1, 2, 3), vec3(-4, 1, 0), vec3(0, 1, 0));
    const auto corners = viewVolumeCorners(clip);
    for (unsigned i = 0; i < 8; ++i) {
        const vec3 corner = unProject(vec2(i & 1U ? 300 : 0, i & 2U ? 200 : 0), i & 4U ? 1 : 0, clip, 300, 200);
        EXPECT_EQ(corner, corners[i]) << i;
    }
}

TEST(UnProject, refusals_say_what_would_have_been_right) {
    const mat4 clip = perspective(50, 1, 1, 10);
    EXPECT_EQ(refusal([&] {
                  unProject({1, 1}, 0.5, clip, 0, 4);
              }),
              "unProject: width must be greater than 0 and finite, 0");
    EXPECT_EQ(refusal([&] {
                  unProject({1, notANumber}, 0.5, clip, 4, 4);
              }),
              "unProject: the pixel must be finite, (1, nan)");
    EXPECT_EQ(refusal([&] { unProject({1, 1}, infinite, clip, 4, 4); }), "unProject: the depth must be finite, inf");
    EXPECT_NE(refusal([&] {
                  unProject({1, 1}, 1, infinitePerspective(50, 1, 1), 4, 4);
              }).find("not be at infinity"),
              std::string::npos);
    EXPECT_NE(refusal([&] {
                  unProject({1, 1}, 0.5, scale(1, 0, 1), 4, 4);
              }).find("must have an inverse"),
              std::string::npos);
}

TEST(DirectionThroughPixel, leads_to_what_is_drawn_there) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const vec3 eye = random.point(10);
        const mat4 view = lookAtAnyRoll(eye, random.point(10));
        const vec2 pixel(random.number(0, 640), random.number(0, 480));
        const bool isParallel = i % 3 == 0;
        const mat4 lens = isParallel   ? ortho(-3, 4, -2, 5, 0.1, 50)
                          : i % 3 == 1 ? infinitePerspective(60, 640.0 / 480, 0.1)
                                       : perspective(60, 640.0 / 480, 0.1, 1e7);
        const vec3 direction = directionThroughPixel(pixel, lens * view, 640, 480);
        EXPECT_NEAR(glm::length(direction), 1, 4e-16);
        const vec3 begins = isParallel ? unProject(pixel, 0, lens * view, 640, 480) : eye;
        const vec4 clip = lens * view * vec4(begins + 20.0 * direction, 1);
        ASSERT_GT(clip.w, 0);
        EXPECT_LT(glm::distance(pixelFromNdc(vec2(clip) / clip.w, 640, 480), pixel), 1e-10) << i;
    }
    // However the depth is mapped
    const mat4 reversed = perspective(60, 1, 0.1, infinite, DepthRange::oneToZero);
    EXPECT_LT(glm::distance(directionThroughPixel({2, 2}, reversed, 4, 4), vec3(0, 0, -1)), 1e-15);
    EXPECT_NE(refusal([] { directionThroughPixel({1, 1}, scale(0, 1, 1), 4, 4); }).find("apart"), std::string::npos);
    EXPECT_NE(refusal([] {
                  directionThroughPixel({1, 1}, scale(1, 1, 0), 4, 4);
              }).find("near from far"),
              std::string::npos);
}

TEST(Reflected, turns_about_the_normal) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const vec3 n = random.direction(), way = random.direction(), off = reflected(way, n);
        EXPECT_NEAR(glm::dot(off, n), -glm::dot(way, n), 1e-15);
        EXPECT_LT(glm::distance(glm::cross(off, n), glm::cross(way, n)), 1e-15);
        EXPECT_EQ(reflected(way, -n), off);
        EXPECT_EQ(off, glm::reflect(way, n));
    }
}

TEST(Refracted, is_snells_and_says_where_all_is_reflected) {
    Random random(4);
    int none = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 n = random.direction();
        vec3 way = random.direction();
        if (glm::dot(way, n) > 0) way = -way;
        const double index = random.logarithmic(0.4, 2.5), sine = glm::length(glm::cross(way, n));
        const auto on = refracted(way, n, index);
        EXPECT_EQ(on.has_value(), sine <= index);
        none += on ? 0 : 1;
        if (!on) continue;
        // Near the limiting angle the root of a rounding is left of the cosine
        EXPECT_NEAR(glm::length(*on), 1, 1e-14);
        EXPECT_NEAR(glm::length(glm::cross(*on, n)) * index, sine, 1e-14);
        EXPECT_LE(glm::dot(*on, n), 0);
        const vec3 glms = glm::refract(way, n, 1 / index);
        if (sine < 0.99 * index) {
            EXPECT_LT(glm::distance(*on, glms), 1e-13);
        }
    }
    EXPECT_GT(none, 100);
    EXPECT_EQ(refusal([] {
                  refracted({0, -1, 0}, {0, 1, 0}, 0);
              }),
              "refracted: the index must be above 0, up to 1e150, 0");
}
