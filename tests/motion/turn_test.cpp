#include "mv/motion/turn.h"

#include "math/support.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

quat anyTurn(Random& random) { return quatFromAxis(random.number(-360, 360), random.direction()); }

double off(const quat& a, const quat& b) { return angleBetween(a, b); }

}  // namespace

TEST(Turn, inverse_undoes) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const quat q = anyTurn(random);
        EXPECT_LT(off(inverse(q) * q, quat()), 1e-13);
        EXPECT_LT(off(q * inverse(q), quat()), 1e-13);
    }
    EXPECT_EQ(inverse({2, 0, 0, 0}), quat());
    EXPECT_EQ(inverse({0, 0, 1e200, 0}), (quat{0, 0, -1, 0}));
    EXPECT_NE(refusal([] { inverse({0, 0, 0, 0}); }).find("must not be 0"), std::string::npos);
}

TEST(Turn, axis_and_angle_come_back) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const vec3 axis = random.direction();
        const double angle = i % 2 == 0 ? random.number(0, 180) : random.logarithmic(1e-200, 180);
        const AxisAngle found = axisAngleOf(quatFromAxis(angle, axis));
        EXPECT_NEAR(found.degrees, angle, 2e-15 * angle);  // nine roundings, to degrees and back among them
        EXPECT_LT(glm::distance(found.axis, axis), 4e-16);
        // More than half a turn is the rest to a whole one, the other way round
        const AxisAngle longer = axisAngleOf(quatFromAxis(360 - angle, axis));
        EXPECT_NEAR(longer.degrees, angle, 1e-13);
        if (angle > 1e-3 && angle < 179.999) {
            EXPECT_LT(glm::distance(longer.axis, -axis), 1e-9);  // of an angle of 1e-3, known to 1e-13
        }
    }
    EXPECT_EQ(axisAngleOf(quat()).degrees, 0);
    EXPECT_EQ(axisAngleOf(quat()).axis, vec3(1, 0, 0));
    EXPECT_EQ(axisAngleOf({0, 0, 3, 0}).degrees, 180);
    EXPECT_EQ(axisAngleOf({0, 0, -3, 0}).axis, vec3(0, -1, 0));
}

TEST(Turn, a_turned_vector_is_the_matrix_product) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const quat q = anyTurn(random);
        const vec3 v = random.point(5);
        EXPECT_LT(glm::distance(turned(q, v), vec3(rotationMatrix(q) * vec4(v, 0))), 1e-14);
        EXPECT_LT(glm::distance(turned({7 * q.w, 7 * q.x, 7 * q.y, 7 * q.z}, v), turned(q, v)), 1e-14);
    }
    EXPECT_EQ(refusal([] { turned(quat(), {0, infinite, 0}); }), "turned: the vector must be finite, (0, inf, 0)");
}

TEST(TurnBetween, leads_from_one_to_the_other_by_the_smallest_turn) {
    Random random(4);
    for (int i = 0; i < 3000; ++i) {
        const vec3 from = random.direction();
        const double close = i % 3 == 0 ? 1 : random.logarithmic(1e-15, 1);
        const vec3 to = i % 3 == 0   ? random.direction()
                        : i % 3 == 1 ? from + close * random.point(1)
                                     : -from + close * random.point(1);
        const quat turn = turnBetween(3.0 * from, to);
        EXPECT_LT(glm::distance(turned(turn, from), glm::normalize(to)), 1e-15) << i;
        // The smallest: its axis is perpendicular to both
        const vec3 axis(turn.x, turn.y, turn.z);
        EXPECT_NEAR(glm::dot(axis, from), 0, 1e-15) << i;
        EXPECT_NEAR(glm::dot(axis, glm::normalize(to)), 0, 1e-15) << i;
        EXPECT_GE(turn.w, 0);
    }
}

TEST(TurnBetween, answers_where_directions_are_the_same_or_opposite) {
    EXPECT_EQ(turnBetween({1, 2, 3}, {2, 4, 6}), quat());
    for (const vec3& from : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 2, 3), vec3(1e-200, 0, 1e-200)}) {
        const quat turn = turnBetween(from, -2.0 * from);
        EXPECT_EQ(turn.w, 0);
        EXPECT_LE(glm::distance(turned(turn, from), -from),
                  1e-15 * std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)}));
    }
    // In the order that the header names: z before y before x
    EXPECT_EQ(turnBetween({1, 0, 0}, {-1, 0, 0}), (quat{0, 0, -1, 0}));
    EXPECT_EQ(turnBetween({0, 0, 1}, {0, 0, -1}), (quat{0, -1, 0, 0}));
    EXPECT_EQ(refusal([] { turnBetween({0, 0, 0}, {1, 0, 0}); }), "turnBetween: a direction must not be 0, (0, 0, 0)");
    EXPECT_EQ(refusal([] {
                  turnBetween({1, 0, 0}, {notANumber, 0, 0});
              }),
              "turnBetween: a direction must be finite, (nan, 0, 0)");
}

TEST(TurnExtremes, a_hair_short_of_opposite) {
    // From 1 + cos, as it is mostly written, w is 0 and the axis without a digit
    for (const double little : {1e-8, 1e-12, 1e-16, 1e-160}) {
        const AxisAngle turn = axisAngleOf(turnBetween({1, 0, 0}, {-1, little, 0}));
        EXPECT_NEAR(turn.degrees, 180 - degrees(little), 3e-14);
        EXPECT_EQ(turn.axis, vec3(0, 0, 1));
    }
    EXPECT_NEAR(axisAngleOf(turnBetween({1, 0, 0}, {1, 1e-200, 0})).degrees / degrees(1e-200), 1, 1e-15);
}

TEST(Euler, orders_are_the_products_of_matrices) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const vec3 a = vec3(random.number(-360, 360), random.number(-360, 360), random.number(-360, 360));
        const auto is = [&](EulerOrder order) { return rotationMatrix(quatFromEuler(a, order)); };
        EXPECT_LT(largestDifference(is(EulerOrder::xyz), rotateX(a.x) * rotateY(a.y) * rotateZ(a.z)), 3e-15);
        EXPECT_LT(largestDifference(is(EulerOrder::zyx), rotateZ(a.z) * rotateY(a.y) * rotateX(a.x)), 3e-15);
        EXPECT_LT(largestDifference(is(EulerOrder::yxz), rotateY(a.y) * rotateX(a.x) * rotateZ(a.z)), 3e-15);
    }
}

TEST(Euler, angles_come_back) {
    Random random(6);
    for (const EulerOrder order : {EulerOrder::yxz, EulerOrder::xyz, EulerOrder::zyx}) {
        for (int i = 0; i < 1000; ++i) {
            vec3 a(random.number(-180, 180), random.number(-180, 180), random.number(-180, 180));
            const int middle = order == EulerOrder::yxz ? 0 : 1;
            a[middle] /= 2;
            const EulerAngles found = eulerAnglesOf(quatFromEuler(a, order), order);
            EXPECT_LT(off(quatFromEuler(found.degrees, order), quatFromEuler(a, order)), 1e-12);
            if (std::abs(a[middle]) < 89) {
                EXPECT_LT(glm::distance(found.degrees, a), 1e-11);  // 1e-14 over the cosine of 89 degrees
            }
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_LE(found.degrees[axis], axis == middle ? 90 : 180);
                EXPECT_GE(found.degrees[axis], axis == middle ? -90 : -180);
            }
        }
        EXPECT_EQ(eulerAnglesOf(quat(), order).degrees, vec3(0));
        const vec3 half = eulerAnglesOf(quatFromEuler({0, 0, -180}, order), order).degrees;
        EXPECT_EQ(half.z, 180) << "in (-180, 180]";
    }
}

TEST(Euler, lock_is_said) {
    for (const EulerOrder order : {EulerOrder::yxz, EulerOrder::xyz, EulerOrder::zyx}) {
        for (const double end : {90.0, -90.0}) {
            vec3 a(20, 30, 40);
            const int middle = order == EulerOrder::yxz ? 0 : 1, last = order == EulerOrder::zyx ? 0 : 2;
            a[middle] = end;
            const EulerAngles found = eulerAnglesOf(quatFromEuler(a, order), order);
            EXPECT_TRUE(found.locked);
            EXPECT_EQ(found.degrees[middle], end);
            EXPECT_EQ(found.degrees[last], 0);
            EXPECT_LT(off(quatFromEuler(found.degrees, order), quatFromEuler(a, order)), 1e-12);
        }
    }
}
