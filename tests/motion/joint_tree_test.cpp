#include "mv/motion/joint_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "math/support.h"
#include "motion/arms.h"
#include "mv/error.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

void build(const std::vector<Joint>& joints) { const JointTree tree(joints); }

// A body with two arms: 0 the hip, 1 the back, 2 and 3 the left arm, 4 the right one, 5 its hand, which is fixed to it.
JointTree body() {
    return JointTree({{.parentFromJoint = translate(0, 1, 0), .axis = {0, 1, 0}},
                      {.parent = 0, .parentFromJoint = translate(0, 0.5, 0), .axis = {1, 0, 0}},
                      {.parent = 1, .parentFromJoint = translate(-0.2, 0.5, 0) * rotateZ(-90), .axis = {0, 0, 3}},
                      {.parent = 2, .parentFromJoint = translate(0, 0.3, 0), .axis = {1, 1, 0}},
                      {.parent = 1, .parentFromJoint = translate(0.2, 0.5, 0) * rotateZ(90)},
                      {.parent = 4, .parentFromJoint = translate(0, 0.3, 0) * rotateY(30), .kind = JointKind::fixed}});
}
const std::vector<double> pose{20, -35, 70, 110, -15, 0};

TEST(JointTree, PutsEachJointAtTheProductAlongItsPath) {
    const auto worldFromJoint = body().worldFromJoints(pose);
    const mat4 back = translate(0, 1, 0) * rotateY(20) * translate(0, 0.5, 0) * rotateX(-35);
    const mat4 left = back * translate(-0.2, 0.5, 0) * rotateZ(-90) * rotateZ(70);
    const mat4 elbow = left * translate(0, 0.3, 0) * rotate(110, vec3(1, 1, 0));
    const mat4 hand = back * translate(0.2, 0.5, 0) * rotateZ(90) * rotateZ(-15) * translate(0, 0.3, 0) * rotateY(30);
    // Five products of matrices with entries up to 2.
    EXPECT_LT(largestDifference(worldFromJoint[1], back), 5e-15);
    EXPECT_LT(largestDifference(worldFromJoint[3], elbow), 5e-15);
    EXPECT_LT(largestDifference(worldFromJoint[5], hand), 5e-15);
}

TEST(JointTree, AnAngleMovesWhatHangsOnItsJointAndNothingElse) {
    const JointTree tree = body();
    const auto before = tree.worldFromJoints(pose);
    std::vector<double> other = pose;
    other[2] += 25;
    const auto after = tree.worldFromJoints(other);
    for (const std::size_t i : {0U, 1U, 4U, 5U}) EXPECT_EQ(before[i], after[i]) << i;
    for (const std::size_t i : {2U, 3U}) EXPECT_GT(largestDifference(before[i], after[i]), 0.1) << i;
    EXPECT_EQ(vec3(before[2][3]), vec3(after[2][3])) << "a joint turns about where it is";
}

TEST(JointTree, ThePathHasTheJointsThatMoveTheEnd) {
    const JointTree tree = body();
    EXPECT_EQ(tree.pathTo(3), (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(tree.pathTo(5), (std::vector<std::size_t>{0, 1, 4, 5}));
    EXPECT_EQ(tree.pathTo(0), (std::vector<std::size_t>{0}));
}

TEST(JointTree, TheEndIsWhereItsJointCarriesIt) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Arm arm = randomArm(random, 5);
        const auto angles = randomAngles(random, arm.tree);
        const vec4 carried = arm.tree.worldFromJoints(angles).back() * vec4(arm.end.offset, 1);
        // Five rotations and translations of points up to 7 away: some dozens of roundings of 7.
        EXPECT_LT(glm::length(arm.tree.endPosition(angles, arm.end) - vec3(carried)), 3e-14);
    }
}

TEST(JointTree, TheJacobianIsTheDerivative) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Arm arm = randomArm(random, 5);
        const auto angles = randomAngles(random, arm.tree);
        const auto columns = arm.tree.jacobianPerRadian(angles, arm.end);
        ASSERT_EQ(columns.size(), angles.size());
        for (std::size_t k = 0; k < columns.size(); ++k) {
            // Central differences over h = 1e-3 degrees: h^2/6 of a third derivative of 7 is 4e-10, and roundings of
            // 1e-14 over h, which is 1.7e-5 rad, 1e-9.
            auto less = angles, more = angles;
            less[k] -= 1e-3;
            more[k] += 1e-3;
            const vec3 difference = (arm.tree.endPosition(more, arm.end) - arm.tree.endPosition(less, arm.end)) /
                                    (radians(more[k]) - radians(less[k]));
            EXPECT_LT(glm::length(columns[k] - difference), 5e-9) << k;
        }
    }
}

TEST(JointTree, TheJacobianIsZeroForWhatDoesNotMoveTheEnd) {
    const auto columns = body().jacobianPerRadian(pose, {5, {0.1, 0, 0}});
    for (const std::size_t i : {2U, 3U, 5U}) EXPECT_EQ(columns[i], vec3(0)) << i;
    for (const std::size_t i : {0U, 1U, 4U}) EXPECT_GT(glm::length(columns[i]), 0.05) << i;
}

// The lecture's example: two links that turn about z, angles 60 and 250 degrees, rates 1.2 and -0.1 rad/s.
TEST(JointTree, TheLecturesTwoLinks) {
    const Arm arm = planeArm({2, 1});
    const std::vector<double> angles{60, 250};
    const vec3 end = arm.tree.endPosition(angles, arm.end);
    const double sine50 = 0.766044443118978, cosine50 = 0.6427876096865394, root3 = 1.7320508075688772;
    // Products and sums of numbers up to 2.
    EXPECT_LT(glm::length(end - vec3(1 + cosine50, root3 - sine50, 0)), 1e-15);
    const auto columns = arm.tree.jacobianPerRadian(angles, arm.end);
    const vec3 velocity = 1.2 * columns[0] - 0.1 * columns[1];
    const vec3 byHand(-1.2 * (root3 - sine50) - 0.1 * sine50, 1.2 * (1 + cosine50) - 0.1 * cosine50, 0);
    EXPECT_LT(glm::length(velocity - byHand), 3e-15);
}

TEST(JointTree, AHundredThousandJointsInOnePass) {
    // The links are the sides of a regular polygon: its last corner is its first.
    constexpr int count = 100'000;
    const Arm arm = planeArm(std::vector<double>(count, 1.0));
    std::vector<double> angles(count, 360.0 / count);
    // Each turn is off by an ulp of 6e-5 rad or so, and of the direction, 1e-16: a walk of 1e5 steps of 1e-16, times
    // the way.
    EXPECT_LT(glm::length(arm.tree.endPosition(angles, arm.end)), 1e-6);
    const auto worldFromJoint = arm.tree.worldFromJoints(angles);
    EXPECT_LT(glm::length(vec3(worldFromJoint.back() * vec4(arm.end.offset, 1))), 1e-6);
}

TEST(JointTree, KeepsAnAxisAndLengthsOfAnySize) {
    for (const double size : {1e-200, 1e-6, 1e6, 1e90}) {
        const double axis = size < 1 ? size : 1 / size;
        const JointTree tree({{.axis = {0, 0, axis}}, {.parent = 0, .parentFromJoint = translate(size, 0, 0)}});
        const vec3 end = tree.endPosition(std::vector<double>{90, 90}, {1, {size, 0, 0}});
        EXPECT_LT(glm::length((end - vec3(-size, size, 0)) / size), 1e-15) << size;
    }
}

TEST(JointTree, RefusesWhatIsNoTree) {
    EXPECT_THROW(build({}), Error);
    EXPECT_THROW(build({{.parent = 0}}), Error);  // its own
    EXPECT_THROW(build({{}, {.parent = 2}, {.parent = 0}}), Error);
    EXPECT_THROW(build({{.axis = {0, 0, 0}}}), Error);
    EXPECT_THROW(build({{.axis = {0, NAN, 0}}}), Error);
    EXPECT_THROW(build({{.least = 10, .most = 9}}), Error);
    EXPECT_THROW(build({{.least = NAN}}), Error);
    EXPECT_NO_THROW(build({{.least = 10, .most = 10}}));
}

TEST(JointTree, RefusesWhatIsNotRigid) {
    EXPECT_THROW(build({{.parentFromJoint = scale(2)}}), Error);
    EXPECT_THROW(build({{.parentFromJoint = scale(1, 1, -1)}}), Error);
    EXPECT_THROW(build({{.parentFromJoint = mat4(fmat4(rotateX(30)))}}), Error);
    EXPECT_THROW(build({{.parentFromJoint = translate(1e101, 0, 0)}}), Error);
    mat4 projection(1);
    projection[0][3] = 1;
    EXPECT_THROW(build({{.parentFromJoint = projection}}), Error);
    mat4 hole(1);
    hole[1][2] = NAN;
    EXPECT_THROW(build({{.parentFromJoint = hole}}), Error);
    mat4 turned(1);
    for (int i = 0; i < 50; ++i) turned = turned * rotate(7 * i, vec3(1, i, -2));
    EXPECT_NO_THROW(build({{.parentFromJoint = turned}}));
}

TEST(JointTree, RefusesWrongAngles) {
    const JointTree tree = body();
    EXPECT_THROW(tree.worldFromJoints(std::vector<double>(5)), Error);
    std::vector<double> angles = pose;
    angles[1] = NAN;
    EXPECT_THROW(tree.worldFromJoints(angles), Error);
    EXPECT_THROW(tree.endPosition(angles, {3}), Error);
    EXPECT_THROW(tree.jacobianPerRadian(angles, {3}), Error);
    angles = pose;
    angles[5] = 1;  // the fixed one
    EXPECT_THROW(tree.worldFromJoints(angles), Error);
    EXPECT_THROW(tree.parentFromTurned(5, 1), Error);
    EXPECT_THROW(tree.endPosition(pose, {6}), Error);
    EXPECT_THROW(tree.endPosition(pose, {3, {0, 0, INFINITY}}), Error);
}

}  // namespace
