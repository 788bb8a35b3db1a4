#include "mv/motion/orientation.h"

#include <array>
#include <cmath>

#include "math/support.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

// The same in degrees, 57.3 times as much.
constexpr double degreeRounding = 60 * rounding;

quat negated(const quat& q) { return {-q.w, -q.x, -q.y, -q.z}; }
quat times(double factor, const quat& q) { return {factor * q.w, factor * q.x, factor * q.y, factor * q.z}; }

double quatDifference(const quat& a, const quat& b) {
    return std::max({std::abs(a.w - b.w), std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}
double dot(const quat& a, const quat& b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }

quat randomOrientation(Random& random) { return quatFromAxis(random.number(-360, 360), random.direction()); }

// The axes of quarter and half turns, where components vanish, and some others.
std::vector<vec3> axes() {
    std::vector<vec3> list{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, -1}, {-1, 0, 1}, {1, 1, 1}, {1e-9, 1, 0}};
    Random random(3);
    for (int i = 0; i < 50; ++i) list.push_back(random.direction());
    return list;
}

TEST(Quaternion, TurnsAsTheMatrixOfItsAxisAndAngle) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const double angle = random.number(-800, 800);
        const vec3 axis = random.logarithmic(1e-3, 1e3) * random.direction();
        const quat q = quatFromAxis(angle, axis);
        EXPECT_NEAR(dot(q, q), 1, rounding);
        // rotate() has angles of up to 2 pi rad, whose rounding is that much larger
        EXPECT_LT(largestDifference(rotationMatrix(q), rotate(angle, axis)), 3 * rounding);
    }
    EXPECT_EQ(quatFromAxis(0, {1, 2, 3}), quat{});
    EXPECT_EQ(quatFromAxis(180, {0, 2, 0}), (quat{0, 0, 1, 0}));
    EXPECT_EQ(quatFromAxis(360, {0, 2, 0}), (quat{-1, 0, 0, 0}));
    EXPECT_EQ(quatFromAxis(720e9, {0, 2, 0}), quat{});
    EXPECT_EQ(rotationMatrix(quatFromAxis(180, {0, 1, 0})), mat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1));
}

TEST(Quaternion, AndItsNegativeAreOneOrientation) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const quat q = randomOrientation(random);
        EXPECT_EQ(rotationMatrix(q), rotationMatrix(negated(q)));
        EXPECT_LT(quatDifference(quatFromAxis(i + 360, {1, 2, 3}), negated(quatFromAxis(i, {1, 2, 3}))), rounding);
        EXPECT_EQ(angleBetween(q, negated(q)), 0);
    }
}

TEST(Quaternion, OfAnyLengthGivesTheSameOrthogonalMatrix) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const quat q = randomOrientation(random);
        const mat4 m = rotationMatrix(q);
        // Nine roundings of an entry, 1e-15, move the product of two columns by 2 * sqrt(3) as much.
        EXPECT_LT(orthogonalityError(m), 4e-15);
        EXPECT_NEAR(glm::determinant(m), 1, 4e-15);
        for (const double size : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000}) {
            EXPECT_LT(largestDifference(rotationMatrix(times(size, q)), m), rounding);
            EXPECT_LT(quatDifference(times(size, q) * times(1 / size, q), q * q), rounding);
            EXPECT_LT(angleBetween(times(size, q), q), degreeRounding);
        }
    }
}

TEST(Quaternion, ComesBackFromEveryRotationMatrix) {
    for (const vec3& axis : axes()) {
        for (const double angle : {0.0, 1e-9, 0.1, 45.0, 89.9, 90.0, 119.9, 120.1, 179.0, 180 - 1e-9, 180.0}) {
            const quat q = quatFromAxis(angle, axis), back = quatFromMatrix(rotationMatrix(q));
            EXPECT_NEAR(dot(back, back), 1, rounding);
            EXPECT_GE(back.w, 0);
            EXPECT_LT(std::min(quatDifference(back, q), quatDifference(back, negated(q))), rounding) << angle;
        }
    }
    // Half turns: of the two the one whose first component is positive
    EXPECT_EQ(quatFromMatrix(mv::scale(1, -1, -1)), (quat{0, 1, 0, 0}));
    EXPECT_EQ(quatFromMatrix(mv::scale(-1, 1, -1)), (quat{0, 0, 1, 0}));
    EXPECT_EQ(quatFromMatrix(mv::scale(-1, -1, 1)), (quat{0, 0, 0, 1}));
    EXPECT_EQ(quatFromMatrix(rotationMatrix({0, -1, -1, 0})), quatFromMatrix(rotationMatrix({0, 1, 1, 0})));
}

TEST(Quaternion, ProductIsTheMatricesProduct) {
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const quat a = randomOrientation(random), b = randomOrientation(random), c = randomOrientation(random);
        EXPECT_LT(largestDifference(rotationMatrix(a * b), rotationMatrix(a) * rotationMatrix(b)), rounding);
        EXPECT_LT(quatDifference((a * b) * c, a * (b * c)), rounding);
        const quat product = times(3, a) * times(5, b);
        EXPECT_NEAR(dot(product, product), 1, rounding);
    }
    // Not the other way round: a quarter about x, then one about y
    const vec4 z = rotationMatrix(quatFromAxis(90, {0, 1, 0}) * quatFromAxis(90, {1, 0, 0})) * vec4(0, 0, 1, 0);
    EXPECT_LT(glm::length(z - vec4(0, -1, 0, 0)), rounding);
}

TEST(AngleBetween, IsTheAngleOfTheTurnBetween) {
    Random random(6);
    for (int i = 0; i < 500; ++i) {
        const quat from = randomOrientation(random);
        const double angle = i % 3 == 0 ? random.logarithmic(1e-12, 1) : random.number(0, 180);
        const quat to = quatFromAxis(angle, random.direction()) * from;
        EXPECT_NEAR(angleBetween(from, to), angle, degreeRounding);
        EXPECT_EQ(angleBetween(from, to), angleBetween(to, from));
        EXPECT_NEAR(angleBetween(from, negated(to)), angle, degreeRounding);
    }
    EXPECT_EQ(angleBetween({1, 0, 0, 0}, {0, 0, 1, 0}), 180);
    EXPECT_EQ(angleBetween({1, 0, 0, 0}, {1, 0, 0, 0}), 0);
    EXPECT_NEAR(angleBetween({1, 0, 0, 0}, {1, 0, 1e-100, 0}) / degrees(2e-100), 0, 1);  // never more than there is
}

// ---- slerp

TEST(Slerp, TurnsAtConstantSpeedAboutOneAxis) {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const quat from = randomOrientation(random);
        const double angle = i % 3 == 0 ? random.logarithmic(1e-9, 1) : random.number(1, 179.9);
        const vec3 axis = random.direction();
        const quat to = quatFromAxis(angle, axis) * from;
        for (const double t : {-1.5, -0.2, 0.0, 0.1, 0.5, 0.75, 1.0, 1.3, 4.0}) {
            const quat is = slerp(from, to, t);
            EXPECT_NEAR(dot(is, is), 1, rounding);
            // The error of the ends' angle goes on at the same speed beyond them.
            EXPECT_LT(angleBetween(is, quatFromAxis(t * angle, axis) * from), degreeRounding * (1 + std::abs(t))) << t;
            EXPECT_LT(angleBetween(slerp(from, to, t, Way::longer), quatFromAxis(t * (angle - 360), axis) * from),
                      // The axis is known to the rounding of what is left of the ends' sum.
                      degreeRounding * (1 + std::abs(t)) / std::sin(radians(angle / 2)) * 360)
                << t;
        }
    }
}

TEST(Slerp, BeginsAndEndsAtItsEnds) {
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const quat from = randomOrientation(random), to = randomOrientation(random);
        for (const Way way : {Way::shorter, Way::longer}) {
            // One division by a length of 1: an ulp
            EXPECT_LT(quatDifference(slerp(from, to, 0, way), from), 2.3e-16);
            const quat end = slerp(from, to, 1, way);
            EXPECT_LT(std::min(quatDifference(end, to), quatDifference(end, negated(to))), 2.3e-16);
            // and without a jump there
            EXPECT_LT(quatDifference(slerp(from, to, 1e-17, way), slerp(from, to, 0, way)), rounding);
            EXPECT_LT(quatDifference(slerp(from, to, 1 - 0x1p-53, way), end), rounding);
        }
        EXPECT_LT(quatDifference(slerp(from, from, 0.3), from), 2.3e-16);
    }
}

TEST(Slerp, IsTheSameFromBothEndsAndForBothSigns) {
    Random random(9);
    for (int i = 0; i < 300; ++i) {
        const quat from = randomOrientation(random);
        const quat to = i % 3 == 0 ? quatFromAxis(180, random.direction()) * from : randomOrientation(random);
        for (const double t : {0.0, 0.25, 0.5, 0.9}) {
            for (const Way way : {Way::shorter, Way::longer}) {
                const quat is = slerp(from, to, t, way);
                EXPECT_LT(angleBetween(is, slerp(to, from, 1 - t, way)), degreeRounding);
                EXPECT_LT(angleBetween(is, slerp(negated(from), to, t, way)), degreeRounding);
                EXPECT_LT(angleBetween(is, slerp(from, negated(to), t, way)), degreeRounding);
                EXPECT_LT(angleBetween(is, slerp(times(7, from), times(1e-200, to), t, way)), degreeRounding);
            }
            EXPECT_LT(angleBetween(nlerp(from, to, t), nlerp(to, from, 1 - t)), degreeRounding);
            EXPECT_LT(angleBetween(nlerp(from, to, t), nlerp(from, negated(to), t)), degreeRounding);
        }
    }
}

TEST(Slerp, TakesTheShorterWayAndAtHalfTurnsTheDocumentedOne) {
    const quat none{}, most = quatFromAxis(170, {0, 1, 0}), over = quatFromAxis(190, {0, 1, 0});
    EXPECT_LT(angleBetween(slerp(none, most, 0.5), quatFromAxis(85, {0, 1, 0})), degreeRounding);
    EXPECT_LT(angleBetween(slerp(none, over, 0.5), quatFromAxis(-85, {0, 1, 0})), degreeRounding);
    EXPECT_LT(angleBetween(slerp(none, over, 0.5, Way::longer), quatFromAxis(95, {0, 1, 0})), degreeRounding);
    // About the axis whose first component is positive
    for (const vec3 axis : {vec3(0, 1, 0), vec3(0, -1, 0)}) {
        const quat half = quatFromAxis(180, axis);
        EXPECT_LT(angleBetween(slerp(none, half, 0.5), quatFromAxis(90, {0, 1, 0})), degreeRounding);
        EXPECT_LT(angleBetween(slerp(none, half, 0.5, Way::longer), quatFromAxis(-90, {0, 1, 0})), degreeRounding);
    }
}

TEST(Slerp, GoesRoundTheLongerWayUnlessThereIsNoAxis) {
    const quat none{};
    for (const double angle : {1e-3, 1e-6, 1e-9}) {
        const quat to = quatFromAxis(angle, {1, 0, 0});
        // The rest of the ends' sum is angle/2 rad, with roundings of 1.
        EXPECT_LT(angleBetween(slerp(none, to, 0.5, Way::longer), quatFromAxis(angle / 2 - 180, {1, 0, 0})),
                  degreeRounding / radians(angle / 2));
    }
    EXPECT_EQ(refusal([] {
                  slerp({1, 0, 0, 0}, {-1, 0, 0, 0}, 0.5, Way::longer);
              }),
              "slerp: the longer way must have an axis: ends must be 4e-12 rad apart, 0 rad");
    EXPECT_EQ(refusal([] { slerp({1, 0, 0, 0}, {1, 0, 0, 0}, 0.5); }), "nothing was refused");
}

TEST(Nlerp, IsSlerpAtTheEndsAndInTheMiddleAndNearElsewhere) {
    Random random(10);
    double most = 0;
    for (int i = 0; i < 300; ++i) {
        const quat from = randomOrientation(random), to = quatFromAxis(180, random.direction()) * from;
        for (const double t : {0.0, 0.5, 1.0}) {
            EXPECT_LT(angleBetween(nlerp(from, to, t), slerp(from, to, t)), degreeRounding);
        }
        for (const double t : {0.2, 0.237, 0.8}) {
            const quat is = nlerp(from, to, t);
            EXPECT_NEAR(dot(is, is), 1, rounding);
            most = std::max(most, angleBetween(is, slerp(from, to, t)));
            // On the arc, and not beside it
            EXPECT_NEAR(angleBetween(from, is) + angleBetween(is, to), 180, degreeRounding);
        }
    }
    EXPECT_LT(most, 8.2);
    EXPECT_GT(most, 8.1);  // as the header says
    const quat far = nlerp({1, 0, 0, 0}, quatFromAxis(90, {1, 0, 0}), 1e6);
    EXPECT_NEAR(dot(far, far), 1, rounding);
}

// ---- yaw, pitch and roll

TEST(YawPitchRoll, IsTheProductOfTheThreeTurns) {
    Random random(11);
    for (int i = 0; i < 300; ++i) {
        const double yaw = random.number(-400, 400), pitch = random.number(-400, 400), roll = random.number(-400, 400);
        const quat q = quatFromYawPitchRoll(yaw, pitch, roll);
        EXPECT_LT(largestDifference(rotationMatrix(q), rotateY(yaw) * rotateX(pitch) * rotateZ(roll)),
                  // three times the angles' roundings of up to 2 pi rad
                  5 * rounding);
    }
    // A thing that looks along -z, y up: to the left, nose up, left side down
    const auto looks = [](double yaw, double pitch, double roll, const vec4& v) {
        return vec3(rotationMatrix(quatFromYawPitchRoll(yaw, pitch, roll)) * v);
    };
    EXPECT_LT(looks(30, 0, 0, {0, 0, -1, 0}).x, -0.4);
    EXPECT_GT(looks(0, 30, 0, {0, 0, -1, 0}).y, 0.4);
    EXPECT_LT(looks(0, 0, 30, {0, 1, 0, 0}).x, -0.4);
}

TEST(YawPitchRoll, ComesBackOverTheWholeRange) {
    for (int yaw = -179; yaw <= 180; yaw += 13) {
        for (const double pitch : {-89.9999, -89.0, -60.0, -1e-5, 0.0, 17.0, 45.0, 89.0, 89.999999}) {
            for (int roll = -175; roll <= 180; roll += 11) {
                const quat q = quatFromYawPitchRoll(yaw, pitch, roll);
                for (const YawPitchRoll& is : {yawPitchRollOf(q), yawPitchRollOf(negated(q))}) {
                    // The effect of rounding on either angle alone
                    const double tolerance = 2 * degreeRounding / std::cos(radians(pitch));
                    EXPECT_FALSE(is.locked);
                    EXPECT_NEAR(is.yaw, yaw, tolerance) << pitch << " " << roll;
                    EXPECT_NEAR(is.pitch, pitch, degreeRounding);
                    EXPECT_NEAR(is.roll, roll, tolerance) << yaw << " " << pitch;
                    EXPECT_LT(angleBetween(quatFromYawPitchRoll(is.yaw, is.pitch, is.roll), q), 3 * degreeRounding);
                }
            }
        }
    }
}

TEST(YawPitchRoll, GivesHalfTurnsAsPositive) {
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_EQ(yawPitchRollOf({0, 0, sign, 0}).yaw, 180);
        EXPECT_EQ(yawPitchRollOf({0, 0, 0, sign}).roll, 180);
    }
}

TEST(YawPitchRoll, SaysGimbalLockAndKeepsTheOrientation) {
    Random random(12);
    for (int i = 0; i < 300; ++i) {
        const double pitch = i % 2 == 0 ? 90 : -90, yaw = random.number(-180, 180), roll = random.number(-180, 180);
        const quat q = quatFromYawPitchRoll(yaw, pitch, roll);
        const YawPitchRoll is = yawPitchRollOf(q);
        EXPECT_TRUE(is.locked);
        EXPECT_EQ(is.roll, 0);
        EXPECT_EQ(is.pitch, pitch);
        EXPECT_GT(is.yaw, -180);
        EXPECT_LE(is.yaw, 180);
        EXPECT_NEAR(std::abs(std::remainder(is.yaw - (pitch > 0 ? yaw - roll : yaw + roll), 360.0)), 0,
                    2 * degreeRounding);
        EXPECT_LT(angleBetween(quatFromYawPitchRoll(is.yaw, is.pitch, is.roll), q), 3 * degreeRounding);
    }
    // Near the poles the three angles are still the orientation, locked or not.
    for (double off = 1e-16; off < 1; off *= 3) {
        const quat q = quatFromYawPitchRoll(20, 90 - off, 75);
        const YawPitchRoll is = yawPitchRollOf(q);
        EXPECT_EQ(is.locked, is.roll == 0);
        // The lock's threshold, 1e-14 of the quaternion, is dropped from it.
        EXPECT_LT(angleBetween(quatFromYawPitchRoll(is.yaw, is.pitch, is.roll), q), degrees(4e-14)) << off;
    }
    EXPECT_FALSE(yawPitchRollOf(quatFromYawPitchRoll(20, 90 - 1e-10, 75)).locked);
}

TEST(Orientation, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] {
                  rotationMatrix({0, 0, 0, 0});
              }),
              "rotationMatrix: the quaternion must not be 0, (0, 0, 0, 0)");
    EXPECT_EQ(refusal([] {
                  quat{1, infinite, 0, 0} * quat{};
              }),
              "quaternion product: the quaternion must be finite, (1, inf, 0, 0)");
    EXPECT_EQ(refusal([] {
                  slerp({notANumber, 0, 0, 0}, {}, 0);
              }),
              "slerp: the quaternion must be finite, (nan, 0, 0, 0)");
    EXPECT_EQ(refusal([] { slerp({}, {}, notANumber); }), "slerp: t must be -1e6 to 1e6, nan");
    EXPECT_EQ(refusal([] { nlerp({}, {}, 1e7); }), "nlerp: t must be -1e6 to 1e6, 1e+07");
    EXPECT_EQ(refusal([] { quatFromAxis(10, {0, 0, 0}); }), "quatFromAxis: the axis must not be 0, (0, 0, 0)");
    EXPECT_EQ(refusal([] { quatFromAxis(infinite, {0, 1, 0}); }), "quatFromAxis: the angle must be finite, inf");
    EXPECT_EQ(refusal([] { quatFromYawPitchRoll(0, notANumber, 0); }),
              "quatFromYawPitchRoll: the angle must be finite, nan");
    EXPECT_EQ(refusal([] { quatFromMatrix(mv::scale(2)); }),
              "quatFromMatrix: R^T R must be the identity to 1e-6 (take scales off by decompose), 3 off");
    EXPECT_EQ(refusal([] { quatFromMatrix(mv::scale(1, 1, -1)); }),
              "quatFromMatrix: the matrix must not mirror (take scales off by decompose), determinant -1");
    EXPECT_EQ(refusal([] { quatFromMatrix(mv::scale(1e200)); }),
              "quatFromMatrix: R^T R must be the identity to 1e-6 (take scales off by decompose), inf off");
}

}  // namespace
