#include "mv/math/transform.h"

#include <array>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "support.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 moved(const mat4& m, const vec3& p) { return vec3(m * vec4(p, 1)); }

// ---- translate, scale, rotate

TEST(Translate, MovesPointsAndLeavesDirections) {
    const mat4 m = translate(1, -2, 3);
    EXPECT_EQ(moved(m, {10, 20, 30}), vec3(11, 18, 33));
    EXPECT_EQ(m * vec4(10, 20, 30, 0), vec4(10, 20, 30, 0));
    EXPECT_EQ(m, translate(vec3(1, -2, 3)));
    EXPECT_EQ(m, glm::translate(mat4(1), vec3(1, -2, 3)));
}

TEST(Scale, MultipliesEachCoordinate) {
    EXPECT_EQ(moved(scale(2, -3, 0), {1, 1, 1}), vec3(2, -3, 0));
    EXPECT_EQ(scale(4), scale(4, 4, 4));
    EXPECT_EQ(scale(vec3(2, -3, 0)), glm::scale(mat4(1), vec3(2, -3, 0)));
}

TEST(Rotate, IsRightHanded) {
    // The MV.js of 2016 turned the other way (errata E3); a quarter turn tells.
    EXPECT_LT(glm::distance(moved(rotateX(90), {0, 1, 0}), {0, 0, 1}), rounding);
    EXPECT_LT(glm::distance(moved(rotateY(90), {0, 0, 1}), {1, 0, 0}), rounding);
    EXPECT_LT(glm::distance(moved(rotateZ(90), {1, 0, 0}), {0, 1, 0}), rounding);
}

TEST(Rotate, AgreesWithRotationAboutTheAxesAndWithGlm) {
    for (int i = -96; i <= 96; ++i) {
        const double angle = 7.5 * i;
        const double glmAngle = radians(std::fmod(angle, 360.0));
        EXPECT_LT(largestDifference(rotateX(angle), rotate(angle, {1, 0, 0})), rounding);
        EXPECT_LT(largestDifference(rotateY(angle), rotate(angle, {0, 2, 0})), rounding);
        EXPECT_LT(largestDifference(rotateZ(angle), rotate(angle, {0, 0, 1e-200})), rounding);
        const vec3 axis(1, -2, 0.5);
        EXPECT_LT(largestDifference(rotate(angle, axis), glm::rotate(mat4(1), glmAngle, axis)), rounding);
    }
}

TEST(Rotate, IsRigidAndKeepsItsAxis) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const vec3 axis = random.direction() * std::pow(10.0, random.number(-300, 300));
        const mat4 m = rotate(random.number(-400, 400), axis);
        EXPECT_LT(orthogonalityError(m), rounding);
        EXPECT_NEAR(glm::determinant(mat3(m)), 1, rounding);
        const double size = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
        EXPECT_LT(glm::distance(moved(m, axis / size), axis / size), 2 * rounding);
    }
}

TEST(Rotate, WholeTurnsAreExact) {
    EXPECT_EQ(rotateX(360), mat4(1));
    EXPECT_EQ(rotateY(30 + 360e9), rotateY(30));
    EXPECT_EQ(rotate(-30 - 360e9, {1, 2, 3}), rotate(-30, {1, 2, 3}));
}

// The car of viewpoints drives clockwise: at angle d it is at 100 (sin d, cos d) and heads for (cos d, -sin d).
TEST(Rotate, TurnsTheCarAlongItsTrackWhereTheSlideDoesNot) {
    for (int d = 0; d <= 360; d += 3) {
        const vec3 heading(std::cos(radians(d)), -std::sin(radians(d)), 0);
        EXPECT_LT(glm::distance(moved(rotateZ(-d), {1, 0, 0}), heading), rounding) << d;
        // The slide's rotateZ(d) is off by 2 d: right at 0 and 180 degrees, backwards at 90 and 270.
        const double cosine = glm::dot(moved(rotateZ(d), {1, 0, 0}), heading);
        EXPECT_NEAR(cosine, std::cos(radians(2 * d)), rounding) << d;
    }
}

TEST(Transform, RefusesWhatIsNotFinite) {
    EXPECT_EQ(refusal([] { translate(0, notANumber, 0); }), "translate: the offset must be finite, (0, nan, 0)");
    EXPECT_EQ(refusal([] { scale(infinite); }), "scale: the factors must be finite, (inf, inf, inf)");
    EXPECT_EQ(refusal([] { rotateX(notANumber); }), "rotateX: the angle must be finite, nan");
    EXPECT_EQ(refusal([] { rotateY(infinite); }), "rotateY: the angle must be finite, inf");
    EXPECT_EQ(refusal([] { rotateZ(-infinite); }), "rotateZ: the angle must be finite, -inf");
    EXPECT_EQ(refusal([] { rotate(10, {0, 0, 0}); }), "rotate: the axis must not be 0, (0, 0, 0)");
    EXPECT_EQ(refusal([] { rotate(10, {notANumber, 0, 0}); }), "rotate: the axis must be finite, (nan, 0, 0)");
}

// ---- lookAt

TEST(LookAt, PutsTheEyeAtTheOriginTheTargetAheadAndUpUpwards) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const vec3 eye = random.point(10);
        const vec3 at = random.point(10);
        const vec3 up = random.point(10);
        const mat4 camera = lookAt(eye, at, up);
        // Coordinates of up to 10: a few roundings of 10 (1.8e-15 each).
        EXPECT_LT(glm::distance(moved(camera, eye), {0, 0, 0}), 2e-14);
        EXPECT_LT(glm::distance(moved(camera, at), {0, 0, -glm::distance(eye, at)}), 4e-14);
        const vec4 upImage = camera * vec4(up, 0);
        EXPECT_NEAR(upImage.x, 0, 4e-14);
        EXPECT_GT(upImage.y, 0);
        EXPECT_LT(orthogonalityError(camera), rounding);
        EXPECT_NEAR(glm::determinant(mat3(camera)), 1, rounding);
    }
}

TEST(LookAt, AgreesWithGlmInOrdinaryCases) {
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const vec3 eye = random.point(10);
        const vec3 at = random.point(10);
        const vec3 up = random.direction();
        if (glm::length(glm::cross(glm::normalize(at - eye), up)) < 0.1) continue;
        // GLM does not normalise its third vector, and 0.1 rad of up magnifies a rounding tenfold; entries up to 17.
        EXPECT_LT(largestDifference(lookAt(eye, at, up), glm::lookAtRH(eye, at, up)), 1e-13);
    }
}

// The operations of MV.js in its order: difference, normalize by division, cross, cross, dot.
TEST(LookAt, HasTheBitsOfMvJs) {
    const auto normalized = [](const vec3& v) { return v / std::sqrt(glm::dot(v, v)); };
    Random random(4);
    for (int i = 0; i < 500; ++i) {
        const vec3 eye = random.point(250);
        const vec3 at = random.point(250);
        const vec3 up = random.direction();
        const vec3 v = normalized(at - eye);
        const vec3 across = glm::cross(v, up);
        if (glm::length(across) < 0.1) continue;  // where the plain product would lose a digit
        const vec3 n = normalized(across);
        const vec3 u = normalized(glm::cross(n, v));
        mat4 expected(1);
        for (int k = 0; k < 3; ++k) {
            expected[k][0] = n[k];
            expected[k][1] = u[k];
            expected[k][2] = -v[k];
        }
        expected[3] = vec4(-glm::dot(n, eye), -glm::dot(u, eye), glm::dot(v, eye), 1);
        // Only the sign of a sum may be taken elsewhere, so even that is exact.
        EXPECT_EQ(lookAt(eye, at, up), expected);
    }
}

// Sizes beyond the ordinary take another way through the code. A power of two rounds nothing, so the way may not show.
TEST(LookAt, HasTheSameBitsAtEverySize) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const vec3 eye = random.point(10);
        const vec3 at = random.point(10);
        const vec3 up = random.direction();
        const mat4 expected = lookAt(eye, at, up);
        for (const double size : {0x1p-400, 0x1p-120, 0x1p-70, 0x1p-60, 0x1p60, 0x1p70, 0x1p120, 0x1p400}) {
            EXPECT_EQ(mat3(lookAt(size * eye, size * at, up)), mat3(expected)) << size;
            EXPECT_EQ(lookAt(eye, at, size * up), expected) << size;
            EXPECT_EQ(mat3(lookAtAnyRoll(size * eye, size * at)), mat3(lookAtAnyRoll(eye, at))) << size;
        }
    }
}

TEST(LookAt, RefusalsSayWhatWouldHaveBeenRight) {
    const vec3 origin(0);
    const vec3 y(0, 1, 0);
    const vec3 z(0, 0, 5);
    EXPECT_EQ(refusal([&] { lookAt(z, z, y); }), "lookAt: eye and at must differ, (0, 0, 5)");
    EXPECT_EQ(refusal([&] { lookAt(z, origin, origin); }), "lookAt: up must not be 0, (0, 0, 0)");
    EXPECT_EQ(refusal([&] { lookAt(vec3(0, 5, 0), origin, y); }),
              "lookAt: up must be at least 1e-12 rad off the line of sight, 0 rad");
    EXPECT_EQ(refusal([&] { lookAt(vec3(0, 5, 0), origin, vec3(5e-13, 1, 0)); }),
              "lookAt: up must be at least 1e-12 rad off the line of sight, 5e-13 rad");
    EXPECT_EQ(refusal([&] { lookAt(vec3(notANumber, 0, 0), origin, y); }), "lookAt: eye must be finite, (nan, 0, 0)");
    EXPECT_EQ(refusal([&] { lookAt(z, vec3(0, infinite, 0), y); }), "lookAt: at must be finite, (0, inf, 0)");
    EXPECT_EQ(refusal([&] { lookAt(z, origin, vec3(0, 0, -infinite)); }), "lookAt: up must be finite, (0, 0, -inf)");
    EXPECT_EQ(refusal([&] { lookAt(vec3(1e301, 0, 0), origin, y); }),
              "lookAt: eye must lie within 1e300 of the origin, (1e+301, 0, 0)");
    EXPECT_EQ(refusal([&] { lookAt(vec3(1e301, 0, 0), vec3(1e301, 0, 5), y); }),
              "lookAt: eye must lie within 1e300 of the origin, (1e+301, 0, 0)");
    EXPECT_EQ(refusal([&] { lookAtAnyRoll(z, z); }), "lookAtAnyRoll: eye and at must differ, (0, 0, 5)");
    EXPECT_EQ(refusal([&] { lookAtAnyRoll(z, vec3(notANumber)); }),
              "lookAtAnyRoll: at must be finite, (nan, nan, nan)");
}

TEST(LookAtAnyRoll, IsUprightInYWhereItCanBe) {
    EXPECT_EQ(lookAtAnyRoll({0, 0, 4}, {0, 0, 0}), lookAt({0, 0, 4}, {0, 0, 0}, {0, 1, 0}));
    EXPECT_EQ(lookAtAnyRoll({4, 0, 0}, {0, 0, 0}), lookAt({4, 0, 0}, {0, 0, 0}, {0, 1, 0}));
    EXPECT_EQ(lookAtAnyRoll({1, 2, 3}, {0, 0, 0}), lookAt({1, 2, 3}, {0, 0, 0}, {1, 0, 0}));
}

// ---- extremes

bool isUsable(const glm::mat4& m) { return orthogonalityError(m) <= 1e-6; }

TEST(LookAtExtremes, X01LooksStraightDown) {
    const mat4 camera = lookAtAnyRoll({0, 5, 0}, {0, 0, 0});
    EXPECT_LE(orthogonalityError(camera), rounding);
    EXPECT_EQ(moved(camera, {0, 0, 0}), vec3(0, 0, -5));     // forward is exact
    EXPECT_EQ(camera * vec4(0, 0, 1, 0), vec4(0, 1, 0, 0));  // and the roll is fixed: +z is at the top
    EXPECT_FALSE(isUsable(glm::lookAt(glm::vec3(0, 5, 0), glm::vec3(0), glm::vec3(0, 1, 0))));
}

TEST(LookAtExtremes, X02UpNearlyParallelToTheView) {
    Random random(5);
    int floatFailures = 0;
    for (const double angle : {0.0, 1e-11, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
        for (int i = 0; i < 250; ++i) {  // 2000 poses
            const vec3 eye = random.point(5);
            const vec3 at = eye + random.number(0.1, 10) * random.direction();
            const vec3 view = glm::normalize(at - eye);
            const vec3 aside = glm::normalize(glm::cross(view, random.direction()));
            const vec3 up = (i % 2 == 0 ? 1.0 : -1.0) * view + angle * aside;
            if (angle > 0) {
                const mat4 camera = lookAt(eye, at, up);
                EXPECT_LE(orthogonalityError(camera), rounding) << angle;
                // As uploaded: rounded to float once, 6e-8 an element.
                EXPECT_LE(orthogonalityError(fmat4(camera)), 1e-6) << angle;
                EXPECT_GE(-(camera * vec4(view, 0)).z, 1 - 1e-7) << angle;
                // The roll is up's: what is left of it across the picture is the rounding of the inputs, 1e-15.
                EXPECT_NEAR((camera * vec4(aside, 0)).x, 0, 1e-14 / angle) << angle;
                EXPECT_GT((camera * vec4(aside, 0)).y, 0) << angle;
            }
            EXPECT_LE(orthogonalityError(lookAtAnyRoll(eye, at)), rounding);
            EXPECT_GE(-(lookAtAnyRoll(eye, at) * vec4(view, 0)).z, 1 - 1e-7);
            if (!isUsable(glm::lookAt(fvec3(eye), fvec3(at), fvec3(up)))) ++floatFailures;
        }
    }
    // The twin in float is unusable in all classes but the last few.
    EXPECT_GT(floatFailures, 1000);
}

TEST(LookAtExtremes, X04LargeAndSmallDistances) {
    const vec3 direction = glm::normalize(vec3(1, 2, 3));
    for (const double size : {1e-320, 1e-300, 1e-200, 1e-23, 1.0, 1e20, 1e200, 1e300}) {
        const vec3 eye = size * direction;
        const mat4 camera = lookAt(eye, {0, 0, 0}, {0, size, 0});
        const mat4 expected = lookAt(direction, {0, 0, 0}, {0, 1, 0});
        // A subnormal 1e-320 has only 2000 steps left in it; the others are as exact as ever.
        const double bound = size < 1e-307 ? 1e-3 : rounding;
        EXPECT_LE(largestDifference(mat3(camera), mat3(expected)), bound) << size;
        EXPECT_LE(orthogonalityError(camera), rounding) << size;
        EXPECT_NEAR(camera[3].z / size, -1, bound) << size;
        EXPECT_LE(orthogonalityError(lookAtAnyRoll(eye, {0, 0, 0})), rounding) << size;
    }
    // The twins: the square of the length overflows or vanishes.
    const fvec3 y(0, 1, 0);
    EXPECT_FALSE(isUsable(glm::lookAt(1e20f * fvec3(direction), fvec3(0), y)));
    EXPECT_FALSE(isUsable(glm::lookAt(1e-23f * fvec3(direction), fvec3(0), y)));
    EXPECT_GT(orthogonalityError(glm::lookAt(1e200 * direction, vec3(0), vec3(0, 1, 0))), 0.1);
    EXPECT_GT(orthogonalityError(glm::lookAt(1e-200 * direction, vec3(0), vec3(0, 1, 0))), 0.1);
}

TEST(LookAtExtremes, X05SceneFarFromTheOrigin) {
    const fvec3 vertex(12, -3, 5);  // relative to base, as in the vertex buffer
    for (const double size : {1e6, 1e7, 1e8}) {
        const vec3 base(size, -0.7 * size, 0.3 * size);
        const vec3 eye = base + vec3(1, 2, 3);
        const vec3 at = base + vec3(12, 0, 4);
        // The truth is the same scene at the origin; the differences are exact, being small numbers of few bits.
        const vec3 expected = moved(lookAt(eye - base, at - base, {0, 0, 1}), vec3(vertex));

        const fmat4 cameraFromModel(lookAt(eye, at, {0, 0, 1}) * translate(base));
        const vec3 ours(fvec3(cameraFromModel * fvec4(vertex, 1)));
        EXPECT_LE(glm::distance(ours, expected), 1e-5) << size;

        const fmat4 twin = glm::lookAt(fvec3(eye), fvec3(at), fvec3(0, 0, 1)) * glm::translate(fmat4(1), fvec3(base));
        const double twinError = glm::distance(vec3(fvec3(twin * fvec4(vertex, 1))), expected);
        EXPECT_FALSE(twinError <= 1e-2) << size;  // also when it is NaN
    }
}

// ---- normalMatrix

TEST(NormalMatrix, KeepsNormalsPerpendicularAndOnTheirSide) {
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        const mat4 m = translate(random.point(5)) * rotate(random.number(0, 360), random.direction()) *
                       scale(random.number(0.1, 3), random.number(0.1, 3), random.number(-3, -0.1)) *
                       rotate(random.number(0, 360), random.direction());
        const vec3 normal = random.direction();
        const vec3 tangent = glm::normalize(glm::cross(normal, random.direction()));
        const vec3 image = glm::normalize(normalMatrix(m) * normal);
        // Roundings of matrices of condition 30.
        EXPECT_NEAR(glm::dot(image, glm::normalize(mat3(m) * tangent)), 0, 1e-13);
        EXPECT_GT(glm::dot(image, mat3(m) * normal), 0);
        const vec3 expected = glm::normalize(glm::inverseTranspose(mat3(m)) * normal);
        EXPECT_LT(glm::distance(image, expected), 1e-13);
    }
}

TEST(NormalMatrix, OfARotationOrAUniformScaleIsTheRotation) {
    const mat4 r = rotate(40, {1, 2, 3});
    EXPECT_EQ(normalMatrix(mat4(1)), mat3(1));
    for (const double factor : {1e-200, 1e-3, 1.0, 7.0, 1e200}) {
        EXPECT_LT(largestDifference(normalMatrix(translate(1, 2, 3) * r * scale(factor)), mat3(r)), rounding) << factor;
    }
}

// As for lookAt.
TEST(NormalMatrix, HasTheSameBitsAtEverySize) {
    Random random(9);
    for (int i = 0; i < 100; ++i) {
        const mat4 m = rotate(random.number(0, 360), random.direction()) *
                       scale(random.number(0.1, 3), random.number(0.1, 3), random.number(-3, 3));
        const mat3 expected = normalMatrix(m);
        for (const double size : {0x1p-400, 0x1p-120, 0x1p-50, 0x1p-40, 0x1p40, 0x1p60, 0x1p120, 0x1p400}) {
            EXPECT_EQ(normalMatrix(scale(size) * m), expected) << size;
        }
    }
}

TEST(NormalMatrix, RefusesInfinityAlsoWhereItDoesNotRead) {
    mat4 far(1);
    far[3] = vec4(1e308, 1e308, 1e308, 1);  // finite, though their sum is not
    EXPECT_EQ(normalMatrix(far), mat3(1));
    for (int column = 0; column < 4; ++column) {
        for (const double bad : {notANumber, infinite, -infinite}) {
            mat4 broken(1);
            broken[column][3] = bad;
            const std::string text = "normalMatrix: the matrix column " + std::to_string(column) + " must be finite";
            EXPECT_EQ(refusal([&] { normalMatrix(broken); }).rfind(text, 0), 0u) << column << bad;
        }
    }
}

// Columns 1e-4 to 1e-9 apart: the plain cross product of them would be wrong from the twelfth or seventh digit on.
TEST(NormalMatrix, IsAccurateWhereThePointsAreSqueezedNearlyFlat) {
    for (const double apart : {0x1p-13, 0x1p-20, 0x1p-30}) {
        mat4 m(1);
        m[0] = vec4(0.3, 0.7, 0.9, 0);
        m[1] = vec4(0.3, 0.7 + apart, 0.9, 0);
        m[2] = vec4(0.3, 0.7, 0.9 + apart, 0);
        const mat3 ours = normalMatrix(m);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                if (k == i) continue;
                // Each column is perpendicular to the other two of m; both have a length of about 1.
                EXPECT_NEAR(glm::dot(ours[i], vec3(m[k])), 0, rounding) << apart << i << k;
            }
        }
    }
}

TEST(NormalMatrix, X38StaysFiniteUnderAFlatteningScale) {
    const mat3 flat = normalMatrix(rotateX(30) * scale(1, 0, 1));
    const vec3 image = glm::normalize(flat * vec3(0, 1, 0));
    EXPECT_LT(glm::distance(image, mat3(rotateX(30)) * vec3(0, 1, 0)), rounding);
    EXPECT_EQ(normalMatrix(scale(0, 0, 1)), mat3(0));  // no surface is left
    EXPECT_EQ(normalMatrix(scale(0)), mat3(0));
    // Nearly none: the squares of the cofactors would vanish.
    const mat3 needle = normalMatrix(scale(1, 1e-200, 1e-200));
    EXPECT_LT(glm::distance(needle * vec3(0, 1, 0), {0, std::sqrt(1.5), 0}), rounding);
    // And too large: the squares would overflow, though those of the columns do not.
    const mat3 large = normalMatrix(scale(8e153, 2, 2));
    EXPECT_LT(glm::distance(large * vec3(0, 1, 0), {0, std::sqrt(1.5), 0}), rounding);
    // The twin: the inverse does not exist.
    EXPECT_FALSE(std::isfinite(glm::inverseTranspose(mat3(scale(1, 0, 1)))[1][1]));
    mat4 broken(1);
    broken[2][1] = notANumber;
    EXPECT_EQ(refusal([&] { normalMatrix(broken); }),
              "normalMatrix: the matrix column 2 must be finite, (0, nan, 1, 0)");
}

}  // namespace
