#include "mv/motion/decomposition.h"

#include "math/support.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

mat4 composed(const Decomposition& parts) {
    return translate(parts.translation) * rotationMatrix(parts.rotation) * mv::scale(parts.scale);
}

// The largest error of an entry, as a part of its column's largest; a column of zeros must come back as one.
double rebuildError(const mat4& m) {
    const mat4 back = composed(decompose(m));
    double worst = 0;
    for (int column = 0; column < 4; ++column) {
        double size = 0, off = 0;
        for (int row = 0; row < 4; ++row) {
            size = std::max(size, std::abs(m[column][row]));
            off = std::max(off, std::abs(back[column][row] - m[column][row]));
        }
        worst = std::max(worst, size == 0 ? off * HUGE_VAL : off / size);
    }
    return worst;
}

// A dozen roundings of 1.1e-16: a matrix, its quaternion, and the matrix again
constexpr double dozenRoundings = 4e-15;

TEST(Decompose, GivesThePartsThatWerePutTogether) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const vec3 offset = random.point(1e3);
        const quat turn = quatFromAxis(random.number(0, 180), random.direction());
        const vec3 scales(random.logarithmic(1e-9, 1e9), random.logarithmic(1e-9, 1e9), random.logarithmic(1e-9, 1e9));
        const mat4 m = composed({offset, turn, scales});
        const Decomposition parts = decompose(m);
        EXPECT_EQ(parts.translation, offset);
        EXPECT_LT(angleBetween(parts.rotation, turn), degrees(dozenRoundings));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(parts.scale[k] / scales[k], 1, dozenRoundings);
        EXPECT_LT(rebuildError(m), dozenRoundings);
    }
}

TEST(Decompose, GivesMirrorsBackAsTheSameMatrix) {
    Random random(2);
    for (const vec3 signs : {vec3(-1, 1, 1), vec3(1, -1, 1), vec3(1, 1, -1), vec3(-1, -1, -1)}) {
        for (int i = 0; i < 50; ++i) {
            const quat turn = quatFromAxis(random.number(0, 180), random.direction());
            const mat4 m = composed({random.point(1), turn, signs * vec3(1, 2, 3)});
            const vec3 scales = decompose(m).scale;
            EXPECT_NEAR(scales.x, -1, dozenRoundings);
            EXPECT_NEAR(scales.y, 2, dozenRoundings);
            EXPECT_NEAR(scales.z, 3, 2 * dozenRoundings);
            EXPECT_LT(rebuildError(m), dozenRoundings);
        }
    }
    // Two mirrors are half a turn.
    EXPECT_EQ(decompose(mv::scale(-1, -1, 1)).scale, vec3(1));
    EXPECT_EQ(decompose(mv::scale(1, -1, 1)).scale, vec3(-1, 1, 1));
    EXPECT_EQ(decompose(mv::scale(1, -1, 1)).rotation, (quat{0, 0, 0, 1}));
}

TEST(Decompose, HandlesEveryScale) {
    Random random(3);
    for (const vec3 scales : {vec3(1e-3), vec3(1e-200), vec3(1e200), vec3(1e-300, 1, 1e300), vec3(0, 1, 2),
                              vec3(1, 0, 2), vec3(1, 2, 0), vec3(0, 0, 3), vec3(0, 3, 0), vec3(3, 0, 0), vec3(0)}) {
        for (int i = 0; i < 50; ++i) {
            const quat turn = quatFromAxis(random.number(0, 180), random.direction());
            const mat4 m = composed({random.point(1), turn, scales});
            const Decomposition parts = decompose(m);
            for (int k = 0; k < 3; ++k) {
                if (scales[k] == 0) {
                    EXPECT_EQ(parts.scale[k], 0);
                } else {
                    EXPECT_NEAR(parts.scale[k] / scales[k], 1, dozenRoundings);
                }
            }
            EXPECT_LT(rebuildError(m), dozenRoundings) << scales.x << " " << scales.y << " " << scales.z;
        }
    }
    EXPECT_EQ(decompose(mv::scale(0)).rotation, quat{});
}

TEST(Decompose, RefusesWhatThreePartsCannotMake) {
    mat4 shear(1);
    shear[1] = vec4(1, 1, 0, 0);
    EXPECT_EQ(refusal([&] {
                  decompose(shear);
              }).rfind("decompose: the matrix must not shear: axes x and y must be perpendicular, 45", 0),
              0u);
    shear = mat4(1);
    shear[2] = vec4(0, 2e-6, 1, 0);
    EXPECT_EQ(refusal([&] {
                  decompose(shear);
              }).rfind("decompose: the matrix must not shear: axes y and z must be perpendicular, 89.99988", 0),
              0u);
    shear[2] = vec4(0, 5e-7, 1, 0);
    EXPECT_EQ(refusal([&] { decompose(shear); }), "nothing was refused");
    shear = mv::scale(1, 2, 1) * rotateZ(45);
    EXPECT_NE(refusal([&] { decompose(shear); }), "nothing was refused");
    mat4 projection(1);
    projection[2][3] = -1;
    EXPECT_EQ(refusal([&] { decompose(projection); }), "decompose: the last row must be 0 0 0 1, (0, 0, -1, 1)");
    projection[2][3] = notANumber;
    EXPECT_NE(refusal([&] { decompose(projection); }), "nothing was refused");
    mat4 large(1);
    large[0] = vec4(1.7e308, 1.7e308, 0, 0);
    EXPECT_EQ(refusal([&] { decompose(large); }), "decompose: scales must not overflow, (1.7e+308, 1.7e+308, 0)");
}

}  // namespace
