#include "mv/math/projection.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "mv/math/transform.h"
#include "support.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 ndcOf(const mat4& clipFromCamera, const vec3& p) { return ndcFromClip(clipFromCamera * vec4(p, 1)); }

// ---- ortho

TEST(Ortho, MapsTheCornersOfItsBoxToTheCube) {
    const mat4 m = ortho(-1, 3, 2, 7, 1, 3);
    EXPECT_LT(glm::distance(ndcOf(m, {-1, 2, -1}), {-1, -1, -1}), rounding);
    EXPECT_LT(glm::distance(ndcOf(m, {3, 7, -3}), {1, 1, 1}), rounding);
    EXPECT_EQ(m, glm::ortho(-1.0, 3.0, 2.0, 7.0, 1.0, 3.0));
}

TEST(Ortho, SwappedBoundsMirror) {
    // Near beyond far is allowed and turns the depth order over, as in the course's sliders.
    EXPECT_EQ(ortho(-1, 1, -1, 1, 3, 1), scale(1, 1, -1) * ortho(-1, 1, -1, 1, 1, 3));
    EXPECT_EQ(ortho(1, -1, -1, 1, 1, 3), scale(-1, 1, 1) * ortho(-1, 1, -1, 1, 1, 3));
}

// Errata E1, with near 1 and far 3: for near = -far the slide's sign cannot be seen.
TEST(Ortho, IsNotTheSlides) {
    mat4 slide = ortho(-1, 1, -1, 1, 1, 3);
    slide[3][2] = +(3.0 + 1.0) / (3.0 - 1.0);
    EXPECT_NEAR(ndcOf(slide, {0, 0, -1}).z, 3, rounding);  // 2 (f+n)/(f-n) = 4 too far
    EXPECT_NEAR(ndcOf(slide, {0, 0, -3}).z, 5, rounding);
    EXPECT_NEAR(ndcOf(ortho(-1, 1, -1, 1, 1, 3), {0, 0, -1}).z, -1, rounding);
    EXPECT_NEAR(ndcOf(ortho(-1, 1, -1, 1, 1, 3), {0, 0, -3}).z, 1, rounding);

    // The slide's factor S with 2/(left-right) mirrors x: left comes out on the right.
    const mat4 slideScale = scale(2.0 / (-1.0 - 1.0), 1, 1);
    EXPECT_EQ(ndcOf(slideScale, {-1, 0, 0}).x, 1);
    EXPECT_EQ(ndcOf(ortho(-1, 1, -1, 1, 1, 3), {-1, 0, -1}).x, -1);
}

TEST(Ortho, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] { ortho(2, 2, -1, 1, 1, 3); }), "ortho: left and right must differ, 2");
    EXPECT_EQ(refusal([] { ortho(-1, 1, 0, 0, 1, 3); }), "ortho: bottom and top must differ, 0");
    EXPECT_EQ(refusal([] { ortho(-1, 1, -1, 1, 3, 3); }), "ortho: near and far must differ, 3");
    EXPECT_EQ(refusal([] { ortho(-1, notANumber, -1, 1, 1, 3); }), "ortho: right must be finite, nan");
    EXPECT_EQ(refusal([] { ortho(-1, 1, -1, 1, 1, infinite); }), "ortho: far must be finite, inf");
    // The difference itself overflows, and 2/infinity would flatten the picture without a word.
    EXPECT_EQ(refusal([] { ortho(-1e308, 1e308, -1, 1, 1, 3); }),
              "ortho: the bounds must be neither so close nor so far apart that the matrix overflows");
    EXPECT_EQ(refusal([] { frustum(-1, 1, -1e308, 1e308, 1, 3); }),
              "frustum: the bounds must be neither so close nor so far apart that the matrix overflows");
    EXPECT_EQ(refusal([] { ortho(-1e308, 1e308, -1e-320, 1e-320, 1, 3); }),
              "ortho: the bounds must be neither so close nor so far apart that the matrix overflows");
}

// One test of the matrix stands for all tests of the arguments, so each argument is tried.
TEST(Projections, RefuseEachArgumentThatIsNotFinite) {
    const std::array<std::string, 6> names{"left", "right", "bottom", "top", "near", "far"};
    for (const double bad : {notANumber, infinite, -infinite}) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            std::array<double, 6> b{-1, 1, -1, 1, 1, 3};
            b[i] = bad;
            const std::string ending = names[i] + " must be finite, " + numberText(bad);
            EXPECT_EQ(refusal([&] { ortho(b[0], b[1], b[2], b[3], b[4], b[5]); }), "ortho: " + ending);
            const std::string positive = "near must be greater than 0 and finite, " + numberText(bad);
            EXPECT_EQ(refusal([&] { frustum(b[0], b[1], b[2], b[3], b[4], b[5]); }),
                      "frustum: " + (names[i] == "near" ? positive : ending));
        }
        EXPECT_EQ(refusal([&] { perspective(50, 1, 1, bad); }), "perspective: far must be finite, " + numberText(bad));
        EXPECT_EQ(refusal([&] { perspective(50, bad, 1, 2); }),
                  "perspective: aspect must be greater than 0 and finite, " + numberText(bad));
    }
}

// ---- perspective and frustum

TEST(Perspective, MapsTheEdgesOfItsViewToTheCube) {
    const mat4 m = perspective(60, 2, 0.5, 10);
    const double tangent = std::tan(radians(30));
    EXPECT_LT(glm::distance(ndcOf(m, {-2 * 0.5 * tangent, -0.5 * tangent, -0.5}), {-1, -1, -1}), rounding);
    EXPECT_LT(glm::distance(ndcOf(m, {2 * 10 * tangent, 10 * tangent, -10}), {1, 1, 1}), rounding);
}

TEST(Perspective, AgreesWithGlm) {
    for (const double fovy : {1e-3, 10.0, 50.0, 120.0, 179.9}) {
        for (const double aspect : {0.01, 1.0, 1.5}) {
            const mat4 expected = glm::perspective(radians(fovy), aspect, 0.3, 3.0);
            // Entries of up to cot(fovy/2)/aspect; and GLM's tangent of nearly 90 degrees leaves a rounding of 1 in the
            // cotangent, divided by aspect.
            const double bound = rounding * std::max({1.0, expected[0][0], 1 / aspect});
            EXPECT_LE(largestDifference(perspective(fovy, aspect, 0.3, 3.0), expected), bound) << fovy;
        }
    }
}

TEST(Perspective, HasTheCoursesNumbers) {
    // Ten digits were written down.
    const mat4 viewpoints = perspective(50, 1, 1, 500);
    EXPECT_NEAR(viewpoints[1][1], 2.1445069205, 5e-11);
    EXPECT_NEAR(viewpoints[2][2], -1.0040080160, 5e-11);
    EXPECT_NEAR(viewpoints[3][2], -2.0040080160, 5e-11);
    EXPECT_EQ(viewpoints[2][3], -1);
    const mat4 cube = perspective(65, 1, 0.3, 3);
    EXPECT_NEAR(cube[0][0], 1.5696855771, 5e-11);
    EXPECT_NEAR(cube[2][2], -1.2222222222, 5e-11);
    EXPECT_NEAR(cube[3][2], -0.6666666667, 5e-11);
}

// Errata E21: the slide says that the camera looks along -z and prints the left-handed matrix for depth [0, 1].
TEST(Perspective, IsNotTheSlides) {
    const double n = 0.5;
    const double f = 4;
    mat4 slide(1);
    slide[2] = vec4(0, 0, f / (f - n), 1);
    slide[3] = vec4(0, 0, n * f / (n - f), 0);
    const vec4 atNear(0, 0, -n, 1);
    EXPECT_LT((slide * atNear).w, 0);  // clipping would discard all that is visible
    EXPECT_NEAR((slide * atNear).z / (slide * atNear).w, 2 * f / (f - n), rounding);

    mat4 right(1);
    right[2] = vec4(0, 0, f / (n - f), -1);
    right[3] = vec4(0, 0, n * f / (n - f), 0);
    for (const double z : {-0.5, -0.7, -1.0, -2.0, -4.0}) {
        const vec4 ours = perspective(60, 1, n, f) * vec4(0, 0, z, 1);
        const vec4 theirs = right * vec4(0, 0, z, 1);
        EXPECT_GT(ours.w, 0);
        EXPECT_NEAR(theirs.z / theirs.w, (ours.z / ours.w + 1) / 2, rounding);  // [0, 1] against OpenGL's [-1, 1]
    }
}

TEST(Frustum, MapsTheCornersOfItsWindowAndAgreesWithGlm) {
    const mat4 m = frustum(-0.2, 0.6, -0.1, 0.3, 0.5, 10);
    EXPECT_LT(glm::distance(ndcOf(m, {-0.2, -0.1, -0.5}), {-1, -1, -1}), rounding);
    EXPECT_LT(glm::distance(ndcOf(m, {0.6 * 20, 0.3 * 20, -10}), {1, 1, 1}), rounding);
    EXPECT_LT(largestDifference(m, glm::frustum(-0.2, 0.6, -0.1, 0.3, 0.5, 10.0)), rounding);
}

TEST(Frustum, OfThePerspectivesBoundsIsThePerspective) {
    const FrustumBounds bounds = frustumBounds(50, 1.5, 1, 500);
    EXPECT_NEAR(bounds.top, std::tan(radians(25)), rounding);
    EXPECT_EQ(bounds.right, 1.5 * bounds.top);
    EXPECT_EQ(bounds.left, -bounds.right);
    EXPECT_EQ(bounds.bottom, -bounds.top);
    EXPECT_LT(largestDifference(frustum(bounds), perspective(50, 1.5, 1, 500)), rounding);
}

TEST(PerspectiveExtremes, X06RefusalsSayWhatWouldHaveBeenRight) {
    const std::string fovy = "perspective: fovy must be greater than 0 and less than 180 degrees, ";
    EXPECT_EQ(refusal([] { perspective(0, 1, 1, 2); }), fovy + "0");
    EXPECT_EQ(refusal([] { perspective(180, 1, 1, 2); }), fovy + "180");
    EXPECT_EQ(refusal([] { perspective(notANumber, 1, 1, 2); }), fovy + "nan");
    EXPECT_EQ(refusal([] { perspective(50, 0, 1, 2); }), "perspective: aspect must be greater than 0 and finite, 0");
    EXPECT_EQ(refusal([] { perspective(50, notANumber, 1, 2); }),
              "perspective: aspect must be greater than 0 and finite, nan");
    EXPECT_EQ(refusal([] { perspective(50, 1, 0, 2); }), "perspective: near must be greater than 0 and finite, 0");
    EXPECT_EQ(refusal([] { perspective(50, 1, -1, 2); }), "perspective: near must be greater than 0 and finite, -1");
    EXPECT_EQ(refusal([] { perspective(50, 1, 2, 2); }), "perspective: far must be greater than near, near 2, far 2");
    EXPECT_EQ(refusal([] { perspective(50, 1, 3, 2); }), "perspective: far must be greater than near, near 3, far 2");
    EXPECT_EQ(refusal([] { perspective(50, 1, 1, infinite); }), "perspective: far must be finite, inf");
    EXPECT_EQ(refusal([] { perspective(50, 1, 1e308, 1.5e308); }),
              "perspective: the bounds must be neither so close nor so far apart that the matrix overflows");
    EXPECT_EQ(refusal([] { frustum(1, 1, -1, 1, 1, 2); }), "frustum: left and right must differ, 1");
    EXPECT_EQ(refusal([] { frustum(-1, 1, 2, 2, 1, 2); }), "frustum: bottom and top must differ, 2");
    EXPECT_EQ(refusal([] { frustum(-1, 1, -1, 1, 0, 2); }), "frustum: near must be greater than 0 and finite, 0");
    EXPECT_EQ(refusal([] { frustum(-1, 1, -1, 1, 3, 2); }), "frustum: far must be greater than near, near 3, far 2");
    EXPECT_EQ(refusal([] { frustumBounds(50, 1, 2, 2); }),
              "frustumBounds: far must be greater than near, near 2, far 2");

    // The twins are worse than infinite: finite, and of no use.
    const glm::mat4 nearZero = glm::perspective(glm::radians(50.0f), 1.0f, 0.0f, 10.0f);
    for (const float z : {-0.1f, -1.0f, -9.0f}) {
        const glm::vec4 clip = nearZero * glm::vec4(0, 0, z, 1);
        EXPECT_EQ(clip.z / clip.w, 1.0f);  // every point at the far plane
    }
    const glm::mat4 fovPi = glm::perspective(glm::pi<float>(), 1.0f, 1.0f, 10.0f);
    EXPECT_LT(std::abs(fovPi[0][0]), 1e-7f);  // everything in one column of pixels
    EXPECT_FALSE(std::isfinite(glm::perspective(1.0f, 1.0f, 2.0f, 2.0f)[2][2]));
    EXPECT_FALSE(std::isfinite(glm::ortho(1.0f, 1.0f, -1.0f, 1.0f, 1.0f, 2.0f)[0][0]));
}

// ---- the far plane at infinity

TEST(InfinitePerspective, IsTheLimitOfPerspective) {
    for (const double fovy : {10.0, 60.0, 150.0}) {
        const mat4 m = infinitePerspective(fovy, 1.5, 0.25);
        EXPECT_LE(largestDifference(m, perspective(fovy, 1.5, 0.25, 1e15)), rounding) << fovy;
        EXPECT_LE(largestDifference(m, glm::infinitePerspective(radians(fovy), 1.5, 0.25)), m[1][1] * rounding) << fovy;
    }
    const mat4 m = infinitePerspective(60, 1.5, 0.25);
    EXPECT_EQ(ndcOf(m, {0, 0, -0.25}).z, -1);
    EXPECT_EQ(ndcOf(m, {0, 0, -0.5}).z, 0);  // half of the depths for the first 2 near
    EXPECT_LT(ndcOf(m, {0, 0, -1e9}).z, 1);
    EXPECT_GT(ndcOf(m, {0, 0, -1e9}).z, ndcOf(m, {0, 0, -1e8}).z);
}

// The need of shadow volumes: a direction in view is at depth 1, not a rounding beyond it, where it would be clipped.
TEST(InfinitePerspective, PutsDirectionsExactlyOnTheFarEnd) {
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const mat4 worldFromObject =
            translate(random.point(1e4)) * rotate(random.number(0, 360), random.direction()) * scale(random.point(3));
        const mat4 clipFromObject = infinitePerspective(random.number(1, 179), 1.5, random.number(0.001, 10)) *
                                    lookAt(random.point(100), random.point(1), random.direction()) * worldFromObject;
        const fmat4 rounded(clipFromObject);  // as Program::set uploads it
        const fvec4 clip = rounded * fvec4(fvec3(random.point(5)), 0);
        EXPECT_EQ(clip.z, clip.w) << i;
    }
}

TEST(InfinitePerspective, RefusalsSayWhatWouldHaveBeenRight) {
    const std::string fovy = "infinitePerspective: fovy must be greater than 0 and less than 180 degrees, ";
    EXPECT_EQ(refusal([] { infinitePerspective(0, 1, 1); }), fovy + "0");
    EXPECT_EQ(refusal([] { infinitePerspective(180, 1, 1); }), fovy + "180");
    EXPECT_EQ(refusal([] { infinitePerspective(notANumber, 1, 1); }), fovy + "nan");
    for (const double bad : {0.0, -1.0, notANumber, infinite}) {
        EXPECT_EQ(refusal([&] { infinitePerspective(50, bad, 1); }),
                  "infinitePerspective: aspect must be greater than 0 and finite, " + numberText(bad));
        EXPECT_EQ(refusal([&] { infinitePerspective(50, 1, bad); }),
                  "infinitePerspective: near must be greater than 0 and finite, " + numberText(bad));
    }
    EXPECT_EQ(refusal([] { infinitePerspective(50, 1, 1e308); }),
              "infinitePerspective: the bounds must be neither so close nor so far apart that the matrix overflows");
}

// ---- planes

double inside(const vec4& plane, const vec3& p) { return glm::dot(plane, vec4(p, 1)); }

TEST(PlanesFromClip, AreUnitAndHoldWhatTheClipVolumeHolds) {
    Random random(7);
    const mat4 clipFromWorld = perspective(50, 1.5, 0.5, 20) * lookAt({1, 2, 3}, {-4, 0, 1}, {0, 1, 0});
    const auto planes = planesFromClip(clipFromWorld);
    for (const vec4& plane : planes) EXPECT_NEAR(glm::length(vec3(plane)), 1, rounding);
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 p = random.point(10);
        const vec4 c = clipFromWorld * vec4(p, 1);
        const bool visible = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) < c.w;
        bool held = true;
        for (const vec4& plane : planes) held = held && inside(plane, p) > 0;
        EXPECT_EQ(held, visible);
        if (visible) ++seen;
    }
    EXPECT_GT(seen, 100);  // the loop has met both sides
    EXPECT_LT(seen, 1900);
}

TEST(PlanesFromClip, OfABoxAreItsSides) {
    const auto planes = planesFromClip(ortho(-1, 3, 2, 7, 1, 5));
    EXPECT_NEAR(inside(planes[leftPlane], {0, 0, 0}), 1, rounding);
    EXPECT_NEAR(inside(planes[rightPlane], {0, 0, 0}), 3, rounding);
    EXPECT_NEAR(inside(planes[bottomPlane], {0, 0, 0}), -2, rounding);
    EXPECT_NEAR(inside(planes[topPlane], {0, 0, 0}), 7, rounding);
    EXPECT_NEAR(inside(planes[nearPlane], {0, 0, 0}), -1, rounding);
    EXPECT_NEAR(inside(planes[farPlane], {0, 0, 0}), 5, rounding);
}

TEST(PlanesExtremes, X07FarPlaneAtLargeRatios) {
    for (const double ratio : {1e2, 1e5, 1e6, 1e7, 1e8}) {
        const double near = 0.1;
        const double far = near * ratio;
        const mat4 clip = perspective(50, 1.5, near, far);
        const auto planes = planesFromClip(clip);
        const auto exact = perspectivePlanes(50, 1.5, near, far);
        for (std::size_t i = 0; i < 6; ++i) {
            // 2 near/far of the far row is left after cancellation, with the rounding of 1: 1.1e-16 * far/near.
            EXPECT_LT(glm::length(vec3(planes[i] - exact[i])), 1e-6);
            EXPECT_NEAR(planes[i].w / std::max(1.0, std::abs(exact[i].w)),
                        exact[i].w / std::max(1.0, std::abs(exact[i].w)), 1e-6);
        }
        EXPECT_EQ(exact[farPlane], vec4(0, 0, 1, far));

        // The twin in float, as Gribb and Hartmann's paper is often copied.
        const glm::mat4 f = glm::transpose(
            glm::perspective(glm::radians(50.0f), 1.5f, static_cast<float>(near), static_cast<float>(far)));
        const glm::vec4 plane = f[3] - f[2];
        const double error = std::abs(static_cast<double>(plane.w / glm::length(glm::vec3(plane))) / far - 1);
        if (ratio >= 1e5) {
            EXPECT_FALSE(error <= 1e-3) << ratio;  // also when it is NaN
        }
    }
    // The parameters lose nothing at any ratio; the matrix says when it has.
    EXPECT_EQ(perspectivePlanes(50, 1.5, 1e-10, 1e10)[farPlane], vec4(0, 0, 1, 1e10));
    for (const double ratio : {1e11, 1e13}) {  // still there in part, mostly noise
        const std::string lost = refusal([&] { planesFromClip(perspective(50, 1.5, 1, ratio)); });
        EXPECT_EQ(lost.rfind("planesFromClip: the far plane's normal must not cancel; for an extreme far/near use "
                             "perspectivePlanes, ",
                             0),
                  0u)
            << lost;
    }
    // The matrix is that of a far plane at infinity where nothing of it is left.
    EXPECT_EQ(perspective(50, 1.5, 1, 1e20), infinitePerspective(50, 1.5, 1));
    EXPECT_EQ(planesFromClip(perspective(50, 1.5, 1, 1e20))[farPlane], vec4(0, 0, 0, 1));
    // What is left, however little, is a plane that is somewhere, and not at infinity.
    mat4 nearlyGone = 1e306 * infinitePerspective(50, 1.5, 1);
    nearlyGone[0][3] = 1e-27;
    const std::string lost = refusal([&] { planesFromClip(nearlyGone); });
    EXPECT_EQ(lost.rfind("planesFromClip: the far plane's normal must not cancel", 0), 0u) << lost;
}

TEST(Planes, AreThoseOfAnyMultipleOfTheMatrix) {
    const mat4 clipFromWorld = perspective(50, 1.5, 0.1, 100) * lookAt(vec3(3, 4, 5), vec3(0, 1, 0), vec3(0, 1, 0));
    const auto planes = planesFromClip(clipFromWorld);
    // Powers of two round nothing; 1e-200 and 1e200 round each element once, of which the far plane's normal, a
    // difference, keeps 2e-3
    for (const double power : {0x1p-60, 0x1p60, 0x1p-700, 0x1p700}) {
        EXPECT_EQ(planesFromClip(power * clipFromWorld), planes) << power;
    }
    for (const double factor : {1e-200, 1e200}) {
        const auto scaled = planesFromClip(factor * clipFromWorld);
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_LT(glm::length(scaled[i] - planes[i]), 1e-11) << factor << ", plane " << i;  // d is up to 100
        }
    }
    // A plane that cancels still does
    EXPECT_EQ(refusal([] {
                  planesFromClip(1e-200 * perspective(50, 1.5, 1, 1e13));
              }).rfind("planesFromClip: the far plane's normal must not cancel", 0),
              0u);
}

TEST(Planes, AreFiveWhereTheFarOneIsAtInfinity) {
    const mat4 view = rotateY(30) * translate(-1, -2, -3);
    const auto fromArguments = perspectivePlanes(50, 1.5, 0.5, infinite);
    const auto finite = perspectivePlanes(50, 1.5, 0.5, 20);
    for (std::size_t i = 0; i < farPlane; ++i) EXPECT_EQ(fromArguments[i], finite[i]) << i;
    EXPECT_EQ(fromArguments[farPlane], vec4(0, 0, 0, 1));
    for (const double factor : {1.0, 3.0, 1e-200, 1e200}) {
        const auto camera = planesFromClip(factor * infinitePerspective(50, 1.5, 0.5));
        const auto world = planesFromClip(factor * (infinitePerspective(50, 1.5, 0.5) * view));
        for (std::size_t i = 0; i < farPlane; ++i) {
            EXPECT_LT(glm::length(camera[i] - finite[i]), 4 * rounding) << i;
            EXPECT_NEAR(glm::length(vec3(world[i])), 1, rounding) << i;
        }
        EXPECT_EQ(camera[farPlane], vec4(0, 0, 0, 1));
        EXPECT_EQ(world[farPlane], vec4(0, 0, 0, 1));
        // The planes hold what the matrix shows, however far away, and a direction is held by the far plane, too.
        Random random(8);
        for (int i = 0; i < 2000; ++i) {
            const vec3 p = random.logarithmic(1, 1e12) * random.direction();
            const vec4 c = infinitePerspective(50, 1.5, 0.5) * view * vec4(p, 1);
            const bool visible = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) <= c.w;
            const bool held = std::ranges::all_of(world, [&](const vec4& plane) { return inside(plane, p) >= 0; });
            ASSERT_EQ(held, visible) << i;
        }
        EXPECT_EQ(glm::dot(world[farPlane], vec4(random.direction(), 0)), 0);
    }
    // Behind which everything lies, and of which nothing is left
    mat4 behind = infinitePerspective(50, 1.5, 0.5);
    behind[3].z = -behind[3].z;
    EXPECT_EQ(refusal([&] { planesFromClip(behind); }).rfind("planesFromClip: the far plane's normal", 0), 0u);
    EXPECT_EQ(refusal([] { planesFromClip(mv::scale(1, 1, 0)); }).rfind("planesFromClip: the near plane's normal", 0),
              0u);
    EXPECT_EQ(refusal([] { perspectivePlanes(50, 1.5, infinite, infinite); }).rfind("perspectivePlanes: near must", 0),
              0u);
    EXPECT_NE(refusal([] { perspectivePlanes(50, 1.5, 0, infinite); }), "");
    EXPECT_NE(refusal([] { perspectivePlanes(50, 1.5, 1, -infinite); }), "");
    EXPECT_NE(refusal([] { perspectivePlanes(50, 1.5, 1, notANumber); }), "");
}

TEST(Planes, RefuseWhatIsNoProjection) {
    EXPECT_EQ(refusal([] { planesFromClip(mat4(0)); }).rfind("planesFromClip: the left plane's normal", 0), 0u);
    EXPECT_EQ(refusal([] { planesFromClip(mat4(notANumber)); }).rfind("planesFromClip: the matrix column 0", 0), 0u);
    EXPECT_EQ(refusal([] { perspectivePlanes(0, 1, 1, 2); }),
              "perspectivePlanes: fovy must be greater than 0 and less than 180 degrees, 0");
}

// ---- corners of a volume

TEST(ViewVolumeCorners, GoToTheCornersOfTheCube) {
    const mat4 clipFromWorld =
        perspective(65, 1.5, 0.3, 3) * lookAt(vec3(3, 4, 5), vec3(0, 1, 0), vec3(0, 1, 0)) * scale(1, 2, 1);
    const auto corners = viewVolumeCorners(clipFromWorld);
    for (unsigned i = 0; i < 8; ++i) {
        const vec3 cube((i & 1U) ? 1 : -1, (i & 2U) ? 1 : -1, (i & 4U) ? 1 : -1);
        // The inverse's condition is some far/near * coordinates: 100 roundings.
        EXPECT_LT(glm::distance(ndcOf(clipFromWorld, corners[i]), cube), 100 * rounding) << i;
    }
}

TEST(ViewVolumeCorners, AreTheArgumentsOfOrthoAndFrustum) {
    const auto box = viewVolumeCorners(ortho(-1, 3, 2, 7, 1, 3));
    EXPECT_LT(glm::distance(box[0], {-1, 2, -1}), 10 * rounding);
    EXPECT_LT(glm::distance(box[7], {3, 7, -3}), 10 * rounding);
    const auto pyramid = viewVolumeCorners(frustum(-1, 3, 2, 7, 1, 3));
    EXPECT_LT(glm::distance(pyramid[1], {3, 2, -1}), 10 * rounding);
    EXPECT_LT(glm::distance(pyramid[6], {-3, 21, -3}), 100 * rounding);  // coordinates of 21
}

TEST(ViewVolumeCorners, RefusesWhatHasNone) {
    EXPECT_EQ(refusal([] { viewVolumeCorners(scale(1, 1, 0)); }).rfind("viewVolumeCorners: the matrix must have", 0),
              0U);
    mat4 endless = frustum(-1, 1, -1, 1, 1, 3);
    endless[2][2] = -1;  // the limit of far to infinity
    endless[3][2] = -2;
    EXPECT_EQ(refusal([&] { viewVolumeCorners(endless); }).rfind("viewVolumeCorners: the matrix must have", 0), 0U);
    // Singular, but 1/7 and 4/7 are rounded: elimination finds a last pivot, and an answer that solves nothing.
    const mat4 flat(1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1);
    EXPECT_EQ(refusal([&] { viewVolumeCorners(flat); }),
              "viewVolumeCorners: the matrix must have an inverse, and the volume an end, none for (-1, -1, -1, 1)");
    EXPECT_EQ(refusal([] { viewVolumeCorners(mat4(notANumber)); }).rfind("viewVolumeCorners: the matrix", 0), 0U);
}

// ---- after the projection

TEST(NdcFromClip, DividesAndRefusesWhatLiesBehindTheEye) {
    EXPECT_EQ(ndcFromClip({1, -2, 3, 4}), vec3(0.25, -0.5, 0.75));
    EXPECT_EQ(refusal([] {
                  ndcFromClip({1, 2, 3, 0});
              }),
              "ndcFromClip: w must be greater than 0 (clip before dividing), (1, 2, 3, 0)");
    EXPECT_EQ(refusal([] {
                  ndcFromClip({1, 2, 3, -1});
              }),
              "ndcFromClip: w must be greater than 0 (clip before dividing), (1, 2, 3, -1)");
    EXPECT_EQ(refusal([] {
                  ndcFromClip({1, 2, 3, notANumber});
              }),
              "ndcFromClip: the clip position must be finite, (1, 2, 3, nan)");
    EXPECT_EQ(refusal([] {
                  ndcFromClip({1, 2, 3, 1e-310});
              }),
              "ndcFromClip: w must be large enough for the quotient not to overflow, (1, 2, 3, 1e-310)");
}

TEST(PixelFromNdc, HasYUpAndCentresAtHalves) {
    EXPECT_EQ(pixelFromNdc(vec2(-1, -1), 640, 480), vec2(0, 0));
    EXPECT_EQ(pixelFromNdc(vec2(1, 1), 640, 480), vec2(640, 480));
    EXPECT_EQ(pixelFromNdc(vec3(0, 0, 0.7), 5, 3), vec2(2.5, 1.5));  // the centre of the middle pixel (2, 1)
    EXPECT_EQ(pixelFromNdc({3, -5}, 2, 2), vec2(4, -4));
    EXPECT_EQ(refusal([] { pixelFromNdc(vec2(0), 0, 480); }),
              "pixelFromNdc: width must be greater than 0 and finite, 0");
    EXPECT_EQ(refusal([] { pixelFromNdc(vec2(0), 640, -1); }),
              "pixelFromNdc: height must be greater than 0 and finite, -1");
    EXPECT_EQ(refusal([] { pixelFromNdc(vec2(0, notANumber), 640, 480); }),
              "pixelFromNdc: the position must be finite, (0, nan)");
    EXPECT_EQ(refusal([] { pixelFromNdc(vec2(1e308, 0), 640, 480); }),
              "pixelFromNdc: the pixel must be finite, (inf, 240)");
}

}  // namespace
