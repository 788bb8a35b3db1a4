#include "mv/math/shadow.h"

#include <vector>

#include "mv/math/robust.h"
#include "mv/math/shadow_textbook.h"
#include "mv/math/transform.h"
#include "support.h"

using namespace mv;
using namespace mv::test;

namespace {

vec3 divided(const vec4& p) { return vec3(p) / p.w; }

// The point where the ray from the light through p meets the plane, by the parameter of the ray: another way to the same point.
vec3 castByRay(const vec4& light, const vec4& plane, const vec3& p) {
    const vec3 n(plane);
    const vec3 direction = light.w == 0 ? vec3(light) : vec3(light) / light.w - p;
    return p - (glm::dot(n, p) + plane.w) / glm::dot(n, direction) * direction;
}

TEST(ShadowProjection, CastsAlongTheRayFromTheLight) {
    Random random(8);
    for (int i = 0; i < 500; ++i) {
        const vec3 normal = random.number(0.1, 10) * random.direction();
        const vec4 plane(normal, random.number(-5, 5));
        const vec3 onPlane = -plane.w / glm::dot(normal, normal) * normal;
        const vec3 up = glm::normalize(normal);
        const double side = i % 2 == 0 ? 1 : -1;  // the light on either side of the plane
        const vec3 position = onPlane + side * random.number(3, 6) * up + glm::cross(up, random.point(3));
        const vec4 light = i % 3 == 0 ? vec4(position - onPlane, 0) : vec4(position, 1) * random.number(0.5, 2);
        const vec3 caster = onPlane + side * random.number(0.1, 2) * up + glm::cross(up, random.point(3));

        const vec4 image = shadowProjection(light, plane) * vec4(caster, 1);
        EXPECT_GT(image.w, 0);
        const vec3 shadow = divided(image);
        // Coordinates of up to 20, divided by heights of about 1.
        EXPECT_LT(glm::distance(shadow, castByRay(light, plane, caster)), 1e-12);
        EXPECT_NEAR((glm::dot(normal, shadow) + plane.w) / glm::length(normal), 0, 1e-12);
        for (const vec4& bound : shadowCasterBounds(light, plane)) EXPECT_GT(glm::dot(bound, vec4(caster, 1)), 0);
    }
}

TEST(ShadowProjection, LeavesThePlaneWhereItIs) {
    const mat4 m = shadowProjection({1, 5, 2, 1}, {0, 2, 0, -2});  // y = 1
    EXPECT_LT(glm::distance(divided(m * vec4(3, 1, -4, 1)), {3, 1, -4}), 1e-14);
}

TEST(ShadowProjection, IsTheTextbooksForTheGround) {
    // The course's: m is the identity but for rows 4: (0, -1/y_l, 0, 0), between translations by the light.
    const vec3 l(0.1, 2, 0.995);
    mat4 m(1);
    m[3][3] = 0;
    m[1][3] = -1 / l.y;
    EXPECT_LT(largestDifference(shadowProjection(vec4(l, 1), ground), l.y * (translate(l) * m * translate(-l))),
              rounding);

    // Errata E5: with the summary slide's +1/y_l the shadow comes out on the wrong side, mirrored in the light.
    mat4 slide = m;
    slide[1][3] = +1 / l.y;
    const vec3 caster(0.5, 0.5, -0.5);
    const vec3 wrong = divided(translate(l) * slide * translate(-l) * vec4(caster, 1));
    const vec3 right = divided(shadowProjection(vec4(l, 1), ground) * vec4(caster, 1));
    EXPECT_NEAR(right.y, 0, rounding);
    EXPECT_NEAR(wrong.y, 2 * l.y, rounding);
    EXPECT_LT(glm::dot(vec3(wrong) - l, vec3(right) - l), 0);
}

// Errata E7: row i is L_i (a, b, c, d); the slide printed the transpose, which is for row vectors.
TEST(ShadowProjection, IsNotTheSlidesTranspose) {
    const vec4 light(8.5, 3, 2, 1);
    const vec4 plane(0, 0, 1, 1.0125);
    const mat4 ours = shadowProjection(light, plane);
    const double dot = glm::dot(light, plane);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            EXPECT_NEAR(ours[column][row], (row == column ? dot : 0) - light[row] * plane[column], rounding);
        }
    }
    const vec4 caster(1, -0.5, 0.25, 1);
    EXPECT_NEAR(divided(ours * caster).z, -1.0125, rounding);
    const vec3 slide = divided(glm::transpose(ours) * caster);
    EXPECT_GT(std::abs(slide.z + 1.0125), 0.1);  // off the plane
    EXPECT_LT(glm::distance(divided(caster * glm::transpose(ours)), divided(ours * caster)),
              rounding);  // row vector: right
}

// The lecture's matrices, where they are right, are ours; the transposed one for row vectors only.
TEST(TextbookShadow, IsShadowProjectionOnEveryPlaneAndAcrossAxes) {
    Random random(11);
    for (int i = 0; i < 300; ++i) {
        vec3 normal = random.direction();
        const bool across = i % 2 == 0;
        if (across) {
            normal = vec3(0);
            normal[i % 3] = i % 4 == 0 ? 1 : -1;
        }
        const vec4 plane(normal, random.number(-3, 3));
        const vec3 position = (random.number(1, 5) - plane.w) * normal + glm::cross(normal, random.point(3));
        const vec4 light = i % 5 == 0 ? vec4(position + plane.w * normal, 0) : vec4(position, 1);
        const mat4 ours = shadowProjection(light, plane);
        const mat4 general = textbookShadow(light, plane);
        const mat4 transposed = glm::transpose(textbookShadow(light, plane, true));
        const mat4 special = across ? textbookShadowAcrossAxis(light, plane) : ours;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                // Roundings of products up to 60, taken in another order
                EXPECT_NEAR(general[column][row], ours[column][row], 1e-13) << i;
                EXPECT_NEAR(transposed[column][row], ours[column][row], 1e-13) << i;
                EXPECT_NEAR(special[column][row], ours[column][row], 1e-13) << i;
            }
        }
    }
}

TEST(ShadowProjection, DoesNotDependOnSideOrLengthOfTheNormal) {
    const vec4 light(1, 5, 2, 1);
    const vec4 plane(0, 1, 0, 1);
    EXPECT_EQ(shadowProjection(light, -plane), shadowProjection(light, plane));
    EXPECT_EQ(shadowProjection(light, 1e200 * plane), shadowProjection(light, plane));
    EXPECT_EQ(shadowProjection(light, 1e-200 * plane), shadowProjection(light, plane));
    EXPECT_EQ(shadowCasterBounds(light, -plane), shadowCasterBounds(light, plane));
}

TEST(ShadowProjection, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] {
                  shadowProjection({0, 2, 0, 1}, {0, 0, 0, 1});
              }),
              "shadowProjection: the plane's normal must not be 0, (0, 0, 0, 1)");
    EXPECT_EQ(refusal([] {
                  shadowProjection({0, 2, 0, notANumber}, ground);
              }),
              "shadowProjection: the light must be finite, (0, 2, 0, nan)");
    EXPECT_EQ(refusal([] {
                  shadowProjection({0, 2, 0, 1}, {0, infinite, 0, 1});
              }),
              "shadowProjection: the plane must be finite, (0, inf, 0, 1)");
    EXPECT_EQ(refusal([] {
                  shadowProjection({0, 2, 0, -1}, ground);
              }),
              "shadowProjection: the light's w must be 0 (direction) or positive (point), (0, 2, 0, -1)");
    EXPECT_EQ(refusal([] {
                  shadowProjection({0, 0, 0, 0}, ground);
              }),
              "shadowProjection: the light must not be 0, (0, 0, 0, 0)");
    EXPECT_EQ(refusal([] {
                  shadowProjection({0, 1e200, 0, 1}, {0, 1, 0, 1e200}, {0, -1e200, 0});
              }),
              "nothing was refused");
    EXPECT_EQ(refusal([] {
                  shadowProjection({1e300, 1e300, 0, 1}, {0, 1, 0, 1e300});
              }),
              "shadowProjection: light and plane must not be so large that the matrix overflows, "
              "(1e+300, 1e+300, 0, 1)");
    EXPECT_EQ(refusal([] {
                  shadowProjection({0, 12, 0, 1}, {0, 1, 0, -10}, {0, 9, 0});
              }),
              "shadowProjection: the origin must lie on the plane, 1 off");
    EXPECT_EQ(refusal([] {
                  shadowCasterBounds({1, 0, 0, 0}, ground);
              }),
              "shadowCasterBounds: the light must be off the plane by more than 1e-12 rad, 0 of 1");
}

// ---- extremes: the plane y = 0 and a point light at (1, 10, 0)

const vec4 pointLight(1, 10, 0, 1);

bool casts(const vec3& p) {
    const auto bounds = shadowCasterBounds(pointLight, ground);
    return glm::dot(bounds[0], vec4(p, 1)) > 0 && glm::dot(bounds[1], vec4(p, 1)) > 0;
}

TEST(ShadowExtremes, X11CasterAboveTheLightIsCutOff) {
    const vec4 anti = shadowProjection(pointLight, ground) * vec4(-1, 12, 0, 1);
    EXPECT_LT(anti.w, 0);
    EXPECT_NEAR(divided(anti).x, 11, rounding * 10);  // the false shadow that dividing would give
    EXPECT_FALSE(casts({-1, 12, 0}));
    EXPECT_TRUE(casts({-1, 9.999, 0}));
}

TEST(ShadowExtremes, X12CasterAtTheLightsHeightIsCutOff) {
    EXPECT_EQ((shadowProjection(pointLight, ground) * vec4(3, 10, 0, 1)).w, 0);
    EXPECT_FALSE(casts({3, 10, 0}));
    EXPECT_EQ(shadowCasterBounds(pointLight, ground)[1], vec4(0, -1, 0, 10));  // the row of w'
}

TEST(ShadowExtremes, X13CasterBehindThePlaneIsCutOff) {
    const vec4 image = shadowProjection(pointLight, ground) * vec4(3, -2, 0, 1);
    EXPECT_GT(image.w, 0);
    EXPECT_NEAR(divided(image).x, 2.0 + 2.0 / 3, rounding * 10);  // a false shadow, and w' does not tell
    EXPECT_FALSE(casts({3, -2, 0}));
    EXPECT_FALSE(casts({3, 0, 0}));
    EXPECT_TRUE(casts({3, 1e-9, 0}));
}

TEST(ShadowExtremes, X14LightInThePlaneIsRefusedAndLightBelowTurnsThePlane) {
    const std::string point =
        "shadowProjection: the light must be off the plane by more than 1e-06 of its distance "
        "from the origin, ";
    EXPECT_EQ(refusal([] { shadowProjection({1, 0, 0, 1}, ground); }), point + "0 of 1");
    EXPECT_EQ(refusal([] { shadowProjection({1, 5e-7, 0, 1}, ground); }).rfind(point + "5e-07 of 1", 0), 0u);
    EXPECT_EQ(refusal([] { shadowProjection({0, -1e-6, 2, 1}, ground); }).rfind(point, 0), 0u);
    EXPECT_EQ(refusal([] { shadowProjection({1, 1.1e-6, 0, 1}, ground); }), "nothing was refused");

    // Below a floor the light shines on its underside.
    const vec4 below(1, -10, 0, 1);
    const vec4 image = shadowProjection(below, ground) * vec4(3, -2, 0, 1);
    EXPECT_GT(image.w, 0);
    EXPECT_LT(glm::distance(divided(image), castByRay(below, ground, {3, -2, 0})), rounding * 10);
    EXPECT_GT(glm::dot(shadowCasterBounds(below, ground)[0], vec4(3, -2, 0, 1)), 0);
    EXPECT_LT(glm::dot(shadowCasterBounds(below, ground)[0], vec4(3, 2, 0, 1)), 0);

    // The twin, the formula unchecked: with the light in the plane every point lands on the light itself.
    const vec4 inPlane(1, 0, 0, 1);
    EXPECT_EQ(divided(-glm::dot(ground, vec4(3, 2, 0, 1)) * inPlane), vec3(1, 0, 0));
}

TEST(ShadowExtremes, X15GrazingDirectionIsLongButRight) {
    const vec4 grazing(1, 1e-7, 0, 0);
    const vec3 shadow = divided(shadowProjection(grazing, ground) * vec4(0, 2, 0, 1));
    EXPECT_NEAR(shadow.x / -2e7, 1, rounding);
    EXPECT_NEAR(shadow.y, 0, rounding);
    EXPECT_NE(refusal([] { shadowProjection({1, 1e-13, 0, 0}, ground); }), "nothing was refused");
}

// X16: a plane 1e6 from the origin, things of size 10 on it. How far from the plane do the shadows fall?
TEST(ShadowExtremes, X16PlaneFarFromTheOrigin) {
    const double size = 10;
    Random random(9);
    double local = 0;
    double worldDouble = 0;
    double worldFloat = 0;
    for (int i = 0; i < 200; ++i) {
        const vec3 n = random.direction();
        const double d = 1e6;
        const vec4 plane(n, -d);
        const vec3 origin = d * n;
        const vec3 aside = glm::normalize(glm::cross(n, random.direction()));
        const vec3 light = origin + size * n + 0.3 * size * aside;
        const vec3 caster = origin + random.number(0.1, 0.5) * size * n + random.number(-1, 1) * size * aside;

        // Distances to the plane, measured where they are small: relative to the origin.
        const fmat4 localMatrix(shadowProjection(vec4(light, 1), plane, origin));
        const vec3 localShadow = divided(vec4(localMatrix * fvec4(fvec3(caster - origin), 1)));
        local = std::max(local, std::abs(glm::dot(n, localShadow)));

        const mat4 world = shadowProjection(vec4(light, 1), plane);
        worldDouble = std::max(worldDouble, std::abs(glm::dot(n, divided(world * vec4(caster, 1)) - origin)));
        const fvec4 uploaded = fmat4(world) * fvec4(fvec3(caster), 1);
        worldFloat = std::max(worldFloat, std::abs(glm::dot(n, divided(vec4(uploaded)) - origin)));
    }
    // The bound the case asks for; a float matrix applied to float vertices of size 10 stays below 1e-5.
    EXPECT_LE(local, 1e-5 * size);
    // The twins: D*D*eps/height = 1e12 * 1.1e-16 / 10 in double, a hundred times too much and 1e9 times more in float.
    EXPECT_GT(worldDouble, 1e-5);
    EXPECT_GT(worldFloat, 1e3);

    const vec3 origin(0, 1e6, 0);
    EXPECT_EQ(shadowProjection({0, 1e6 + 10, 0, 1}, {0, 1, 0, -1e6}, origin), shadowProjection({0, 10, 0, 1}, ground));
}

// ---- reflection

TEST(Reflection, MirrorsInThePlaneAndUndoesItself) {
    Random random(10);
    for (int i = 0; i < 100; ++i) {
        const vec4 plane(random.number(0.1, 5) * random.direction(), random.number(-3, 3));
        const mat4 m = reflection(plane);
        EXPECT_LT(largestDifference(m * m, mat4(1)), 1e-12);  // offsets of up to 60 (plane.w / 0.1, twice)
        EXPECT_NEAR(glm::determinant(mat3(m)), -1, rounding);
        const vec3 p = random.point(5);
        const vec3 image(m * vec4(p, 1));
        const vec3 n(plane);
        EXPECT_NEAR((glm::dot(n, p) + plane.w) / glm::length(n), -(glm::dot(n, image) + plane.w) / glm::length(n),
                    1e-12);
        EXPECT_LT(glm::length(glm::cross(image - p, glm::normalize(n))), 1e-12);
    }
    EXPECT_EQ(vec3(reflection({0, 2, 0, -2}) * vec4(1, 5, 2, 1)), vec3(1, -3, 2));
    EXPECT_EQ(refusal([] { reflection({0, 0, 0, 1}); }), "reflection: the plane's normal must not be 0, (0, 0, 0, 1)");
    EXPECT_EQ(refusal([] {
                  reflection({0, 1e-300, 0, 1e300});
              }),
              "reflection: the plane's normal and distance must not overflow, (0, 1e-300, 0, 1e+300)");
}

// ---- the arithmetic underneath

TEST(Robust, UnitHandlesEverySize) {
    const vec3 expected = unit({1, 2, 3});
    EXPECT_NEAR(glm::length(expected), 1, rounding);
    for (const double size : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000}) EXPECT_EQ(unit(size * vec3(1, 2, 3)), expected);
    EXPECT_EQ(scaledForSquares({0, 0, 0}), vec3(0));
    EXPECT_EQ(scaledForSquares({0, -5e-324, 0}), vec3(0, -1, 0));
    EXPECT_EQ(scaledForSquares({1e-20, 7, 1e20}), vec3(1e-20, 7, 1e20));  // as it is
}

TEST(Robust, DifferenceOfProductsKeepsWhatThePlainFormLoses) {
    const double a = 1 + 0x1p-30;
    const double b = 1 - 0x1p-30;
    EXPECT_EQ(differenceOfProducts(a, b, 1, 1), -0x1p-60);  // exact
    volatile double product = a * b;                        // rounded to 1
    EXPECT_EQ(product - 1, 0);
}

}  // namespace
