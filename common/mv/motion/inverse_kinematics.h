// Inverse kinematics by iteration: the angles of a tree's joints at which its end effector is at a target.
//
// Three methods on one frame: each iteration proposes angles, which are taken only when they bring the end nearer to
// the goal, so that the residual never grows. All sizes are parts of the arm's reach: links of 1e-6 and of 1e6 take the
// same steps.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mv/math/types.h"
#include "mv/motion/joint_tree.h"

namespace mv {

enum class IkMethod {
    // One joint after the other, from the tip to the root, turns the end as near to the goal as it alone can. Source:
    // Wang and Chen, "A combined optimization method for solving the inverse kinematics problem", IEEE T-RA 7 (1991).
    cyclicCoordinateDescent,
    // Along J^T e, e being what is missing, by the length that is best for a linear arm. Cheap, and slow near a
    // straight arm. Source: Buss, "Introduction to inverse kinematics with Jacobian transpose, pseudoinverse and damped
    // least squares methods" (2004).
    jacobianTranspose,
    // J^T (J J^T + lambda^2 I)^-1 e, with lambda^2 in proportion to |e|^2: large where a step would be a guess, and 0
    // at the goal. Source: Buss (2004); the damping: Sugihara, "Solvability-unconcerned inverse kinematics by the
    // Levenberg-Marquardt method", IEEE T-RO 27 (2011).
    dampedLeastSquares,
};

struct IkOptions {
    IkMethod method = IkMethod::dampedLeastSquares;
    double tolerance = 1e-9;   // how near the goal is near enough, as a part of the reach; from 1e-14 to 0.1
    int mostIterations = 100;  // from 0 to 1,000,000; in a demo that goes on from its last angles, a few a picture
    double largestStep = 20;   // degrees: no joint turns by more in one iteration; above 0, up to 180
};

enum class IkEnd {
    reached,      // the target
    atEdge,       // the target is out of reach, and the goal, its projection, is reached
    outOfReach,   // the target is out of reach, and the goal is not reached either
    stalled,      // not reached, though within reach by its distance, and further iterations would hardly come nearer
    notYetThere,  // the iterations are spent
};

struct IkIteration {
    double residual = 0;     // from the goal, in world units, after the iteration
    double largestStep = 0;  // degrees by which the joint turned that turned most
};

struct IkResult {
    IkEnd end = IkEnd::notYetThere;
    std::vector<double> degrees;       // one a joint; those beside the path to the end effector as they were
    vec3 goal{0};                      // the target, or what stands for it when that is out of reach, in world space
    double distance = 0;               // from the target to the end effector, in world units
    std::vector<IkIteration> history;  // [0]: before the first one, which has turned nothing
    std::vector<std::size_t> atLimit;  // joints of the path whose angle is at one of its limits
};

// The angles that bring the end effector to the target, from `start`, in world space and degrees. The answer depends on
// the start: another one may lead to another solution.
//
// Reach: the sum of the distances between the joints of the path that turn, and of the last to the end. A target
// farther than that from the first such joint is projected to 0.999 of it, and one in the hole about that joint, which
// is there when one distance exceeds the sum of all others, to as much outside the hole: there no joint runs after what
// it cannot have, and the arm is not singular. `distance` says what remains. (An arm that has no play, a single link,
// is projected onto its circle.) The reach is that of free joints: axes and limits may allow less, and the end is then
// `stalled`, or `outOfReach`.
//
// Limits hold in every iteration: a joint at its limit stands still while the step would push it on, and the others do
// without it. Stalled: no step comes nearer, or ten iterations have come nearer by less than 5 %.
//
// Refused: angles beyond the joints' limits (move them there yourself), what JointTree::endPosition refuses, a target
// with coordinates beyond 1e100, options out of their range, NaN, infinity. Trap: a straight arm whose target is on its
// own line, nearer to the root: every step is sideways and comes no nearer, with all three methods, and the end is
// `stalled`. Bend it a little before.
IkResult solveInverseKinematics(const JointTree& tree, const EndEffector& end, const vec3& target,
                                std::span<const double> start, const IkOptions& options = {});

}  // namespace mv
