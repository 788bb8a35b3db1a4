// X36: arms that are straight, and targets that they do not reach.
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/math/transform.h"
#include "mv/motion/inverse_kinematics.h"
#include "mv/motion/two_link.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

using Angles = std::vector<double>;

struct Arm {
    JointTree tree;
    EndEffector end;

    double miss(const vec3& target, const Angles& degrees) const {
        return glm::length(target - tree.endPosition(degrees, end));
    }
};

// Links of length 1 that turn about z.
Arm armOf(std::size_t count) {
    std::vector<Joint> joints(count);
    for (std::size_t i = 1; i < count; ++i) joints[i] = {.parent = i - 1, .parentFromJoint = translate(1, 0, 0)};
    return {JointTree(joints), {count - 1, {1, 0, 0}}};
}

// J^T (J J^T)^-1 e in the plane: the usual step, without damping. In radians.
Angles pseudoInverseStep(const Arm& arm, const vec3& target, const Angles& degrees) {
    const auto columns = arm.tree.jacobianPerRadian(degrees, arm.end);
    const vec2 e(target - arm.tree.endPosition(degrees, arm.end));
    glm::dmat2 product(0);
    for (const vec3& column : columns) product += glm::outerProduct(vec2(column), vec2(column));
    const vec2 x = glm::inverse(product) * e;
    Angles step;
    for (const vec3& column : columns) step.push_back(glm::dot(vec2(column), x));
    return step;
}

double largestOf(const Angles& step) {
    double largest = 0;
    for (const double turn : step) largest = worse(largest, std::abs(turn));
    return largest;
}

// The last twenty of a hundred pictures of a demo: one step each, from where the last one ended.
struct Late {
    double step = 0;  // the largest turn of a joint, in radians
    double rest = 0;  // the most by which the end is farther from the target than need be, as a part of the reach, 3
};
constexpr int pictures = 100, late = 80;

// `advance` turns the angles by one step and returns the largest turn, in radians.
template <typename Advance>
Late lateOf(const Arm& arm, double beyond, Angles degreesNow, Advance advance) {
    const vec3 target(0, 3 + beyond, 0);
    Late result;
    for (int i = 0; i < pictures; ++i) {
        const double turn = advance(target, degreesNow);
        if (!std::isfinite(turn)) return {infinite, infinite};
        if (i < late) continue;
        result.step = worse(result.step, turn);
        result.rest = worse(result.rest, (arm.miss(target, degreesNow) - beyond) / 3);
    }
    return result;
}

// The median of 201 starts: the pseudo-inverse's paths are chaotic, so that only their median is the same on another machine.
struct Starts {
    Late naive;  // the medians
    Late ours;   // the worst
};
Starts fromStarts(double beyond) {
    const Arm arm = armOf(3);
    Random random(36);
    Angles steps, rests;
    Starts result;
    for (int i = 0; i < 201; ++i) {
        const Angles start{random.number(-180, 180), random.number(-180, 180), random.number(-180, 180)};
        const Late naive = lateOf(arm, beyond, start, [&](const vec3& target, Angles& now) {
            const Angles step = pseudoInverseStep(arm, target, now);
            for (std::size_t k = 0; k < step.size(); ++k) now[k] += degrees(step[k]);
            return largestOf(step);
        });
        steps.push_back(naive.step);
        rests.push_back(naive.rest);
        const Late ours = lateOf(arm, beyond, start, [&](const vec3& target, Angles& now) {
            const IkResult next = solveInverseKinematics(arm.tree, arm.end, target, now, {.mostIterations = 1});
            now = next.degrees;
            return radians(next.history.back().largestStep);
        });
        result.ours = {worse(result.ours.step, ours.step), worse(result.ours.rest, ours.rest)};
    }
    for (Angles* list : {&steps, &rests}) std::nth_element(list->begin(), list->begin() + 100, list->end());
    result.naive = {steps[100], rests[100]};
    return result;
}

const std::string usualForm = "pseudo-inverse: it runs after what it cannot have; median of 201 starts";
const std::string ourForm =
    "solveInverseKinematics: damped least squares towards 0.999 of the reach; worst of 201 starts";

Row stepRow(const std::string& name, double beyond) {
    const Starts starts = fromStarts(beyond);
    return Row{.id = "X36 " + name + " beyond, step",
               .input = "a target " + name + " beyond the reach of three links of 1",
               .measured = "largest turn of a joint in the last 20 of 100 pictures of one step each (rad)",
               .naive = usualForm,
               .naiveError = starts.naive.step,
               .ours = ourForm,
               .ourError = starts.ours.step,
               .tolerance = 1e-3,
               .reason = "a thousandth of a radian moves the end of 3 by 3 mm: an arm that seems to be at rest"};
}

Row restRow(const std::string& name, double beyond) {
    const Starts starts = fromStarts(beyond);
    return Row{
        .id = "X36 " + name + " beyond, rest",
        .input = "a target " + name + " beyond the reach of three links of 1",
        .measured = "the most by which the end is farther off than need be in these pictures, as a part of the reach",
        .naive = usualForm,
        .naiveError = starts.naive.rest,
        .ours = ourForm,
        .ourError = starts.ours.rest,
        .tolerance = 1e-3 + 1e-9,
        .reason = "the thousandth by which the goal is inside, and the iteration's tolerance"};
}

[[maybe_unused]] const bool nearStep = addRow([] { return stepRow("1e-3", 1e-3); });
[[maybe_unused]] const bool nearRest = addRow([] { return restRow("1e-3", 1e-3); });
[[maybe_unused]] const bool farStep = addRow([] { return stepRow("1", 1); });
[[maybe_unused]] const bool farRest = addRow([] { return restRow("1", 1); });
[[maybe_unused]] const bool farthestStep = addRow([] { return stepRow("100", 100); });
[[maybe_unused]] const bool farthestRest = addRow([] { return restRow("100", 100); });

[[maybe_unused]] const bool straight = addRow([] {
    const Arm arm = armOf(2);
    const Angles start{0, degrees(1e-4)};
    const vec3 end = arm.tree.endPosition(start, arm.end), target = end * (1 - 0.01 / glm::length(end));
    const IkResult result = solveInverseKinematics(arm.tree, arm.end, target, start);
    double ours = result.end == IkEnd::reached ? 0 : infinite;
    for (const IkIteration& iteration : result.history) ours = worse(ours, radians(iteration.largestStep));
    return Row{.id = "X36 straight",
               .input = "two links of 1, the elbow bent by 1e-4 rad, a target 1 cm nearer to the root",
               .measured = "largest turn of a joint in a step on the way there (rad)",
               .naive = "pseudo-inverse",
               .naiveError = largestOf(pseudoInverseStep(arm, target, start)),
               .ours = "solveInverseKinematics: damped least squares",
               .ourError = ours,
               .tolerance = radians(20),
               .reason = "the documented bound of a step, 20 degrees"};
});

[[maybe_unused]] const bool edge = addRow([] {
    const Arm arm = armOf(3);
    const vec3 target(0, 2.999, 0);
    const auto by = [&](IkMethod method) {
        return solveInverseKinematics(arm.tree, arm.end, target, Angles{10, 30, 40},
                                      {.method = method, .mostIterations = 1000});
    };
    const IkResult transpose = by(IkMethod::jacobianTranspose), damped = by(IkMethod::dampedLeastSquares);
    return Row{
        .id = "X36 edge",
        .input = "three links of 1, a target 2.999 away",
        .measured = "how far the end is from the target after 1000 iterations, or where it says that it is stalled",
        .naive = "Jacobian transpose with its best step",
        .naiveError = transpose.end == IkEnd::stalled ? transpose.distance : 0,
        .ours = "solveInverseKinematics: damped least squares",
        .ourError = damped.end == IkEnd::reached ? damped.distance : infinite,
        .tolerance = 3e-9,
        .reason = "the iteration's tolerance, 1e-9 of a reach of 3"};
});

[[maybe_unused]] const bool closedForm = addRow([] {
    const double l1 = 1.1, l2 = 0.7, reach = l1 + l2, hole = l1 - l2;
    double naive = 0, ours = 0;
    for (int i = -20; i <= 20; ++i) {
        for (const double distance : {reach * (1 + i * 1.1e-16), hole * (1 + i * 1.1e-16)}) {
            const vec2 target(distance, 0);
            const auto miss = [&](const TwoLinkAngles& angles) {
                const bool isNumber = std::isfinite(angles.shoulder) && std::isfinite(angles.elbow);
                return isNumber ? glm::length(twoLinkEnd(l1, l2, angles) - target) / reach : infinite;
            };
            const double elbow = std::acos((distance * distance - l1 * l1 - l2 * l2) / (2 * l1 * l2));
            const double shoulder = -std::atan2(l2 * std::sin(elbow), l1 + l2 * std::cos(elbow));
            naive = worse(naive, miss({degrees(shoulder), degrees(elbow)}));
            for (const TwoLinkAngles& angles : twoLinkAngles(l1, l2, target).angles) ours = worse(ours, miss(angles));
        }
    }
    return Row{.id = "X36 two links",
               .input = "two links, targets at the very bounds of their reach, some roundings inside and outside",
               .measured = "how far the end is from the target, as a part of the reach; inf: NaN",
               .naive = "the law of cosines by acos",
               .naiveError = naive,
               .ours = "twoLinkAngles",
               .ourError = ours,
               .tolerance = 2.2e-15 + 1.8e-15,
               .reason = "the target is up to 20 roundings of 1.1e-16 outside, and 16 more are those of the angles"};
});

}  // namespace
