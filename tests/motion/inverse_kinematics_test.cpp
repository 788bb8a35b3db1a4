#include "mv/motion/inverse_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "motion/arms.h"
#include "mv/error.h"
#include "mv/motion/two_link.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr IkMethod methods[] = {IkMethod::cyclicCoordinateDescent, IkMethod::jacobianTranspose,
                                IkMethod::dampedLeastSquares};

IkOptions by(IkMethod method, int mostIterations = 100) { return {.method = method, .mostIterations = mostIterations}; }

IkResult solve(const Arm& arm, const vec3& target, const std::vector<double>& start, const IkOptions& options = {}) {
    return solveInverseKinematics(arm.tree, arm.end, target, start, options);
}

double miss(const Arm& arm, const vec3& target, const IkResult& result) {
    return glm::length(arm.tree.endPosition(result.degrees, arm.end) - target);
}

bool neverGrows(const std::vector<IkIteration>& history) {
    for (std::size_t i = 1; i < history.size(); ++i) {
        if (history[i].residual > history[i - 1].residual) return false;
    }
    return true;
}

double largestStep(const IkResult& result) {
    double largest = 0;
    for (const IkIteration& iteration : result.history) largest = std::max(largest, iteration.largestStep);
    return largest;
}

// Joints of a random arm with limits, all of which allow 0.
Arm limitedArm(Random& random, std::size_t count) {
    const Arm arm = randomArm(random, count);
    std::vector<Joint> joints = arm.tree.joints();
    for (Joint& joint : joints) {
        joint.least = random.number(-90, 0);
        joint.most = random.number(0, 90);
    }
    return {JointTree(joints), arm.end};
}

TEST(InverseKinematics, DampedLeastSquaresReachesWhatIsReachable) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Arm arm = randomArm(random, 6);
        const vec3 target = arm.tree.endPosition(randomAngles(random, arm.tree), arm.end);
        const IkResult result = solve(arm, target, randomAngles(random, arm.tree), {.mostIterations = 1000});
        if (result.end == IkEnd::stalled) continue;  // counted below
        ASSERT_EQ(result.end, IkEnd::reached);
        // The tolerance is 1e-9 of a reach of at most 6 sqrt(3), and what is computed again is off by roundings of
        // that.
        EXPECT_LT(miss(arm, target, result), 1.05e-8);
        EXPECT_NEAR(miss(arm, target, result), result.distance, 1e-13);
        EXPECT_EQ(result.goal, target);
    }
}

// From any start to anywhere: a descent may end in a hollow from which every step leads up, so not all arrive.
TEST(InverseKinematics, HowManyArriveByEachMethod) {
    const double least[] = {0.95, 0.9, 0.98};  // of arms with six joints, which have three to spare
    for (const IkMethod method : methods) {
        Random random(2);
        int arrived = 0;
        constexpr int count = 200;
        for (int i = 0; i < count; ++i) {
            const Arm arm = randomArm(random, 6);
            const vec3 target = arm.tree.endPosition(randomAngles(random, arm.tree), arm.end);
            const IkResult result = solve(arm, target, randomAngles(random, arm.tree), by(method, 2000));
            arrived += result.end == IkEnd::reached ? 1 : 0;
        }
        const double part = static_cast<double>(arrived) / count;
        RecordProperty("arrived" + std::to_string(static_cast<int>(method)), std::to_string(part));
        EXPECT_GE(part, least[static_cast<int>(method)]) << static_cast<int>(method);
    }
}

TEST(InverseKinematics, NoStepLeadsAwayOrTurnsTooFar) {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Arm arm = limitedArm(random, 5);
        const auto start = randomAngles(random, arm.tree);
        const vec3 target = random.point(6);
        const double bound = random.logarithmic(0.1, 90);
        for (const IkMethod method : methods) {
            const IkResult result = solve(arm, target, start, {.method = method, .largestStep = bound});
            EXPECT_TRUE(neverGrows(result.history));
            EXPECT_LE(largestStep(result), bound * (1 + 1e-14) + 1e-13);  // a difference of angles up to 90
            EXPECT_LE(result.history.size(), 101U);
            EXPECT_EQ(result.history.front().largestStep, 0);
            EXPECT_NEAR(result.history.front().residual,
                        glm::length(result.goal - arm.tree.endPosition(start, arm.end)), 1e-13);
            EXPECT_NEAR(result.history.back().residual, miss(arm, result.goal, result), 1e-13);
        }
    }
}

// The iterations of a longer run begin with those of a shorter one, so each is looked at.
TEST(InverseKinematics, LimitsHoldAfterEveryIteration) {
    Random random(4);
    for (int i = 0; i < 30; ++i) {
        const Arm arm = limitedArm(random, 5);
        const auto start = randomAngles(random, arm.tree);
        const vec3 target = random.point(5);
        for (const IkMethod method : methods) {
            for (int iterations = 0; iterations < 30; ++iterations) {
                const IkResult result = solve(arm, target, start, by(method, iterations));
                std::vector<std::size_t> atLimit;
                for (std::size_t k = 0; k < result.degrees.size(); ++k) {
                    const Joint& joint = arm.tree.joints()[k];
                    EXPECT_GE(result.degrees[k], joint.least);
                    EXPECT_LE(result.degrees[k], joint.most);
                    if (result.degrees[k] == joint.least || result.degrees[k] == joint.most) atLimit.push_back(k);
                }
                EXPECT_EQ(result.atLimit, atLimit);
            }
        }
    }
}

// The elbow would have to bend by more than it can: what remains is told by Pythagoras, and the shoulder does what it
// can.
TEST(InverseKinematics, AJointAtItsLimitStandsAndTheOthersGoOn) {
    const JointTree tree({{}, {.parent = 0, .parentFromJoint = translate(2, 0, 0), .least = 0, .most = 90}});
    const Arm arm{tree, {1, {1, 0, 0}}};
    for (const IkMethod method : methods) {
        const IkResult result = solve(arm, {-1.2, 0.9, 0}, {20, 30}, by(method, 1000));
        EXPECT_EQ(result.end, IkEnd::stalled);
        EXPECT_EQ(result.atLimit, (std::vector<std::size_t>{1}));
        EXPECT_EQ(result.degrees[1], 90);
        // Ten iterations that come nearer by 5 % of 0.7: that near the lowest point is flat, of order two.
        EXPECT_NEAR(result.distance, std::sqrt(5.0) - 1.5, 1e-2) << static_cast<int>(method);
    }
    const IkResult result = solve(arm, {-1.2, 0.9, 0}, {20, 30});
    EXPECT_NEAR(result.distance, std::sqrt(5.0) - 1.5, 1e-6);
}

TEST(InverseKinematics, WhatIsBeyondTheReachEndsAtItsProjectionAndSaysSo) {
    Random random(5);
    const Arm arm = planeArm({1.2, 1, 0.8});
    for (int i = 0; i < 100; ++i) {
        const double direction = random.number(-pi, pi), beyond = random.logarithmic(1e-3, 1e3);
        const vec3 outwards(std::cos(direction), std::sin(direction), 0), target = (3 + beyond) * outwards;
        const IkResult result = solve(arm, target, {random.number(-180, 180), 30, 40}, {.mostIterations = 1000});
        ASSERT_EQ(result.end, IkEnd::atEdge) << direction << " " << beyond;
        EXPECT_LT(glm::length(result.goal - 0.999 * 3.0 * outwards), 1e-15 * 10);
        EXPECT_LT(miss(arm, result.goal, result), 3e-9);  // the tolerance, of 3
        EXPECT_NEAR(result.distance, beyond + 0.003, 3e-9 + 1e-15 * beyond);
    }
}

TEST(InverseKinematics, TheHoleIsOutOfReachToo) {
    const Arm arm = planeArm({3, 1});
    for (const vec3& target : {vec3(0.5, 1, 0), vec3(-1.9, 0, 0), vec3(0, 0, 0)}) {
        const IkResult result = solve(arm, target, {20, 100});
        EXPECT_EQ(result.end, IkEnd::atEdge);
        EXPECT_NEAR(glm::length(result.goal), 2.004, 1e-14);  // 1e-3 of the reach outside the hole
        EXPECT_NEAR(result.distance, 2.004 - glm::length(target), 4e-9);
        EXPECT_LT(miss(arm, result.goal, result), 4e-9);
    }
}

TEST(InverseKinematics, AgreesWithTheClosedForm) {
    Random random(6);
    const Arm arm = planeArm({2, 1});
    for (int i = 0; i < 200; ++i) {
        const double distance = random.number(1.05, 2.95), direction = random.number(-pi, pi);
        const vec2 target(distance * std::cos(direction), distance * std::sin(direction));
        const IkResult result = solve(arm, vec3(target, 0), {random.number(-180, 180), random.number(5, 175)});
        ASSERT_EQ(result.end, IkEnd::reached);
        double nearest = 1000;
        for (const TwoLinkAngles& angles : twoLinkAngles(2, 1, target).angles) {
            nearest = std::min(nearest, std::max(std::abs(std::remainder(result.degrees[0] - angles.shoulder, 360)),
                                                 std::abs(std::remainder(result.degrees[1] - angles.elbow, 360))));
        }
        // 3e-9 over the least singular value, of 0.15 or so where the arm is nearly straight, in degrees
        EXPECT_LT(nearest, 2e-6);
    }
}

TEST(InverseKinematics, IsTheSameTwiceAndAtEverySize) {
    Random random(7);
    for (int i = 0; i < 20; ++i) {
        const Arm arm = limitedArm(random, 4);
        const auto start = randomAngles(random, arm.tree);
        const vec3 target = random.point(4);
        const auto scaledBy = [&](double size) {
            std::vector<Joint> joints = arm.tree.joints();
            for (Joint& joint : joints) joint.parentFromJoint[3] *= vec4(vec3(size), 1);
            return Arm{JointTree(joints), {3, size * arm.end.offset}};
        };
        for (const IkMethod method : methods) {
            const IkResult first = solve(scaledBy(1), target, start, by(method));
            for (const double size : {1.0, 0x1p-300, 0x1p-20, 0x1p20, 0x1p300}) {
                const IkResult other = solve(scaledBy(size), size * target, start, by(method));
                EXPECT_EQ(first.degrees, other.degrees) << size;  // powers of two round nothing
                EXPECT_EQ(first.end, other.end);
                EXPECT_EQ(first.distance * size, other.distance);
                EXPECT_EQ(first.history.back().residual * size, other.history.back().residual);
            }
        }
    }
}

TEST(InverseKinematics, ATinyArmAndAFarTarget) {
    for (const double size : {1e-250, 1e-6, 1e6, 1e90}) {
        const Arm arm = planeArm({2 * size, size});
        const IkResult near = solve(arm, {1.5 * size, size, 0}, {10, 20});
        EXPECT_EQ(near.end, IkEnd::reached) << size;
        EXPECT_LE(near.distance, 3e-9 * size);
        const IkResult far = solve(arm, {0, 1e100, 0}, {10, 20});
        EXPECT_EQ(far.end, IkEnd::atEdge) << size;
        EXPECT_NEAR(far.distance / 1e100, 1 - 0.999 * 3 * size / 1e100, 1e-15);
    }
}

// The root is 1e9 away: what is computed from the root on keeps its digits, and the target itself has 1e-7 of them.
TEST(InverseKinematics, FarFromTheOriginItStillArrives) {
    const JointTree tree(
        {{.parentFromJoint = translate(1e9, -1e9, 3)}, {.parent = 0, .parentFromJoint = translate(2, 0, 0)}});
    const IkResult result = solve({tree, {1, {1, 0, 0}}}, {1e9 + 1, -1e9 + 2, 3}, {0, 30});
    EXPECT_EQ(result.end, IkEnd::reached);
    EXPECT_LE(result.distance, 3e-9);
}

TEST(InverseKinematics, WhatIsBesideThePathStaysAsItIs) {
    const JointTree tree({{.parentFromJoint = rotateX(20)},
                          {.parent = 0, .parentFromJoint = translate(1, 0, 0)},
                          {.parent = 0, .parentFromJoint = translate(0, 1, 0), .most = 50},
                          {.parent = 1, .parentFromJoint = translate(1, 0, 0), .kind = JointKind::fixed}});
    const std::vector<double> start{10, 20, 50, 0};
    const IkResult result = solve({tree, {3, {0.5, 0, 0}}}, rotateX(20) * vec4(0.3, 1.2, 0, 1), start);
    EXPECT_EQ(result.end, IkEnd::reached);
    EXPECT_EQ(result.degrees[2], 50);
    EXPECT_EQ(result.degrees[3], 0);
    EXPECT_TRUE(result.atLimit.empty()) << "joint 2 is at its limit, and is not of the path";
}

TEST(InverseKinematics, AtTheEdgeOfItsReach) {
    const Arm arm = planeArm({2, 1});
    const auto near = [&](IkMethod method) { return solve(arm, {2.999, 0, 0}, {30, 60}, by(method, 2000)); };
    const IkResult damped = near(IkMethod::dampedLeastSquares);
    EXPECT_EQ(damped.end, IkEnd::reached);
    EXPECT_LE(damped.history.size(), 31U);  // quadratic convergence: from 1e-2 on the digits double
    // Slow as 1/n and 1/n^2: ten iterations of 200 come 5 % and 10 % nearer.
    EXPECT_EQ(near(IkMethod::jacobianTranspose).end, IkEnd::stalled);
    EXPECT_EQ(near(IkMethod::cyclicCoordinateDescent).end, IkEnd::stalled);
    // At the very edge it is singular, and damping by |e| still arrives.
    EXPECT_EQ(solve(arm, {0, 3, 0}, {30, 60}).end, IkEnd::reached);
}

TEST(InverseKinematics, AStraightArmPulledInwardsSaysThatItIsStalled) {
    const Arm arm = planeArm({2, 1});
    for (const IkMethod method : methods) {
        const IkResult result = solve(arm, {2, 0, 0}, {0, 0}, by(method));
        EXPECT_EQ(result.end, IkEnd::stalled);
        EXPECT_EQ(result.degrees, (std::vector<double>{0, 0}));
        EXPECT_EQ(result.distance, 1);
    }
    EXPECT_EQ(solve(arm, {2, 0, 0}, {0, 1e-3}).end, IkEnd::reached);
}

TEST(InverseKinematics, OddArms) {
    for (const IkMethod method : methods) {
        // One joint: its circle has no inside to be sent to.
        const Arm one = planeArm({2});
        const IkResult onto = solve(one, {0, 5, 0}, {10}, by(method));
        EXPECT_EQ(onto.end, IkEnd::atEdge);
        EXPECT_NEAR(onto.degrees[0], 90, 1e-6);
        EXPECT_NEAR(onto.distance, 3, 1e-8);
        EXPECT_EQ(solve(one, {0, -2, 0}, {10}, by(method)).end, IkEnd::reached);
        // The target at the root: equal links fold.
        const Arm folding = planeArm({1, 1});
        const IkResult folded = solve(folding, {0, 0, 0}, {10, 30}, by(method));
        EXPECT_EQ(folded.end, IkEnd::reached);
        EXPECT_NEAR(std::abs(folded.degrees[1]), 180, 1e-6);
        // A link without length in the middle
        EXPECT_EQ(solve(planeArm({1, 0, 1}), {0.5, 1, 0}, {10, 30, 20}, by(method)).end, IkEnd::reached);
        // No length at all, and no joint that turns
        const IkResult none = solve(planeArm({0, 0}), {3, 4, 0}, {10, 30}, by(method));
        EXPECT_EQ(none.end, IkEnd::atEdge);
        EXPECT_EQ(none.distance, 5);
        const JointTree fixed({{.parentFromJoint = translate(1, 1, 0), .kind = JointKind::fixed}});
        EXPECT_EQ(solve({fixed, {0, {1, 0, 0}}}, {2, 1, 0}, {0}, by(method)).end, IkEnd::reached);
        EXPECT_EQ(solve({fixed, {0, {1, 0, 0}}}, {2, 3, 0}, {0}, by(method)).distance, 2);
        // The end on the axis: turning does not move it.
        const JointTree along(std::vector<Joint>(1));
        EXPECT_EQ(solve({along, {0, {0, 0, 1}}}, {0.6, 0, 0.8}, {0}, by(method)).end, IkEnd::stalled);
        // Already there
        EXPECT_EQ(solve(folding, {2, 0, 0}, {0, 0}, by(method, 0)).end, IkEnd::reached);
        EXPECT_EQ(solve(folding, {1, 0, 0}, {0, 30}, by(method, 0)).end, IkEnd::notYetThere);
    }
}

TEST(InverseKinematics, RefusesWhatItCannotMean) {
    const JointTree tree({{.least = -30, .most = 30}});
    const Arm arm{tree, {0, {1, 0, 0}}};
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(solve(arm, {NAN, 0, 0}, {0}), Error);
    EXPECT_THROW(solve(arm, {0, infinity, 0}, {0}), Error);
    EXPECT_THROW(solve(arm, {0, 1e101, 0}, {0}), Error);
    EXPECT_THROW(solve(arm, {1, 0, 0}, {31}), Error);  // beyond its limit
    EXPECT_THROW(solve(arm, {1, 0, 0}, {NAN}), Error);
    EXPECT_THROW(solve(arm, {1, 0, 0}, {0, 0}), Error);
    EXPECT_THROW(solveInverseKinematics(tree, {1}, {1, 0, 0}, std::vector<double>{0}), Error);
    EXPECT_THROW(solve(arm, {1, 0, 0}, {0}, {.tolerance = 0}), Error);
    EXPECT_THROW(solve(arm, {1, 0, 0}, {0}, {.tolerance = NAN}), Error);
    EXPECT_THROW(solve(arm, {1, 0, 0}, {0}, {.mostIterations = -1}), Error);
    EXPECT_THROW(solve(arm, {1, 0, 0}, {0}, {.largestStep = 0}), Error);
    EXPECT_THROW(solve(arm, {1, 0, 0}, {0}, {.largestStep = 181}), Error);
    EXPECT_THROW(solve(arm, {0, 1, 0}, {0}, {.method = static_cast<IkMethod>(3)}), Error);
}

}  // namespace
