#include "mv/motion/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"
#include "mv/math/transform.h"
#include "mv/motion/ik_chain.h"

namespace mv {
namespace {

constexpr std::string_view solver = "solveInverseKinematics";

// The damping lambda^2 for an error |e| is this times |e|^2, less after a step that was good and more after one that
// was not.
constexpr double firstDamping = 1e-2, leastDamping = 1e-6;
// The damping that is left at the goal: the system of a plane arm, which never moves off its plane, is solvable with
// it.
constexpr double dampingFloor = 1e-15;
// A proposal is halved, or damped more, this many times before nothing is found to come nearer.
constexpr int mostTries = 30;
// Stalled: within so many iterations the residual fell by less than to this part.
constexpr std::size_t stallWindow = 10;
constexpr double stallRatio = 0.95;

using Angles = std::vector<double>;

// x of (J J^T + lambda^2 I) x = e for the columns of J, by the 3x3 matrix's L D L^T: it is positive, so no pivot is
// needed.
vec3 dampedSolution(const std::vector<vec3>& columns, double lambdaSquared, const vec3& e) {
    double a = lambdaSquared, b = 0, c = 0, d = lambdaSquared, f = 0, g = lambdaSquared;  // a b c / b d f / c f g
    for (const vec3& v : columns) {
        a += v.x * v.x;
        b += v.x * v.y;
        c += v.x * v.z;
        d += v.y * v.y;
        f += v.y * v.z;
        g += v.z * v.z;
    }
    const double yx = b / a, zx = c / a;
    // Rounding may take what is left of a pivot; the damping is the least that there is.
    const double secondPivot = std::max(d - yx * b, lambdaSquared);
    const double rest = f - yx * c, zy = rest / secondPivot;
    const double thirdPivot = std::max(g - zx * c - zy * rest, lambdaSquared);
    const double y = e.y - yx * e.x, z = (e.z - zx * e.x - zy * y) / thirdPivot;
    const double solvedY = y / secondPivot - zy * z;
    return {e.x / a - yx * solvedY - zx * z, solvedY, z};
}

// One search, with the angles that it has come to.
class Search {
  public:
    Search(const IkChain& chain, const vec3& goal, const IkOptions& options)
        : chain_(chain),
          goal_(goal),
          options_(options),
          bound_(radians(options.largestStep)),
          degrees_(chain.startDegrees()),
          pose_(chain.poseOf(degrees_)),
          residual_(residualOf(pose_)) {}

    double residual() const { return residual_; }
    const Angles& angles() const { return degrees_; }
    const vec3& end() const { return pose_.end; }

    // Goes nearer; the degrees by which the joint turned that turned most, or none where no step comes nearer.
    std::optional<double> iterate() {
        switch (options_.method) {
            case IkMethod::cyclicCoordinateDescent:
                return takeIfNearer(descended());
            case IkMethod::jacobianTranspose:
                return alongTranspose();
            case IkMethod::dampedLeastSquares:
                return dampedStep();
        }
        throw Error(solver, "the method must be one of IkMethod", std::to_string(static_cast<int>(options_.method)));
    }

  private:
    double residualOf(const IkChain::Pose& pose) const { return glm::length(goal_ - pose.end); }

    double withinLimits(std::size_t i, double degrees) const {
        return std::min(std::max(degrees, chain_.link(i).least), chain_.link(i).most);
    }
    bool isAgainstLimit(std::size_t i, double step) const {
        return (step < 0 && degrees_[i] <= chain_.link(i).least) || (step > 0 && degrees_[i] >= chain_.link(i).most);
    }

    std::optional<double> takeIfNearer(Angles proposal) {
        IkChain::Pose pose = chain_.poseOf(proposal);
        const double residual = residualOf(pose);
        if (!(residual < residual_)) return {};
        double largest = 0;
        for (std::size_t i = 0; i < proposal.size(); ++i)
            largest = std::max(largest, std::abs(proposal[i] - degrees_[i]));
        degrees_ = std::move(proposal);
        pose_ = std::move(pose);
        residual_ = residual;
        return largest;
    }

    // The angles after a step in radians, which is shortened as a whole where a joint would turn too far.
    Angles stepped(const Angles& step) const {
        double largest = 0;
        for (const double turn : step) largest = std::max(largest, std::abs(turn));
        const double factor = largest > bound_ ? bound_ / largest : 1;
        Angles proposal = degrees_;
        for (std::size_t i = 0; i < step.size(); ++i) {
            proposal[i] = withinLimits(i, proposal[i] + degrees(factor * step[i]));
        }
        return proposal;
    }

    Angles descended() const {
        Angles proposal = degrees_;
        vec3 end = pose_.end;
        for (std::size_t i = proposal.size(); i-- > 0;) {
            // Joints nearer to the root are still where they were. Only what is across the axis turns.
            const vec3 axis = pose_.axes[i], from = end - pose_.origins[i], to = goal_ - pose_.origins[i];
            const vec3 fromAcross = from - glm::dot(from, axis) * axis, toAcross = to - glm::dot(to, axis) * axis;
            const double best =
                std::atan2(glm::dot(axis, glm::cross(fromAcross, toAcross)), glm::dot(fromAcross, toAcross));
            const double turn = std::min(std::max(best, -bound_), bound_);
            const double turned = withinLimits(i, degrees_[i] + degrees(turn));
            const mat3 rotation(rotate(turned - degrees_[i], axis));
            proposal[i] = turned;
            end = pose_.origins[i] + rotation * from;
        }
        return proposal;
    }

    // The Jacobian's columns, per radian; 0 for those that are not free.
    std::vector<vec3> columns(const std::vector<char>& isFree) const {
        std::vector<vec3> result(chain_.size(), vec3(0));
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (isFree[i]) result[i] = glm::cross(pose_.axes[i], pose_.end - pose_.origins[i]);
        }
        return result;
    }

    // Steps J^T x, with x from these columns, of joints that are free: those that it pushes against a limit are taken
    // out, until there is none of them.
    template <typename Solve>
    Angles stepOfFree(Solve solve) const {
        std::vector<char> isFree(chain_.size(), 1);
        for (;;) {
            const std::vector<vec3> jacobian = columns(isFree);
            const vec3 x = solve(jacobian);
            Angles step;
            for (const vec3& column : jacobian) step.push_back(glm::dot(column, x));
            bool isDone = true;
            for (std::size_t i = 0; i < step.size(); ++i) {
                if (!isFree[i] || !isAgainstLimit(i, step[i])) continue;
                isFree[i] = 0;
                isDone = false;
            }
            if (isDone) return step;
        }
    }

    std::optional<double> alongTranspose() {
        const vec3 e = goal_ - pose_.end;
        Angles step = stepOfFree([&](const std::vector<vec3>& jacobian) {
            vec3 moved(0);  // J J^T e
            for (const vec3& column : jacobian) moved += glm::dot(column, e) * column;
            const double squares = glm::dot(moved, moved);
            return squares == 0 ? vec3(0) : glm::dot(e, moved) / squares * e;
        });
        for (int i = 0; i < mostTries; ++i) {
            if (const auto taken = takeIfNearer(stepped(step))) return taken;
            for (double& turn : step) turn /= 2;
        }
        return {};
    }

    std::optional<double> dampedStep() {
        const vec3 e = goal_ - pose_.end;
        for (int i = 0; i < mostTries; ++i) {
            const double lambdaSquared = std::max(damping_ * glm::dot(e, e), dampingFloor);
            const Angles step = stepOfFree(
                [&](const std::vector<vec3>& jacobian) { return dampedSolution(jacobian, lambdaSquared, e); });
            if (const auto taken = takeIfNearer(stepped(step))) {
                damping_ = std::max(damping_ / 4, leastDamping);
                return taken;
            }
            damping_ *= 4;
        }
        return {};
    }

    const IkChain& chain_;
    vec3 goal_;
    IkOptions options_;
    double bound_;  // radians
    double damping_ = firstDamping;
    Angles degrees_;
    IkChain::Pose pose_;
    double residual_;
};

void requireOptions(const IkOptions& options) {
    if (!(options.tolerance >= 1e-14 && options.tolerance <= 0.1)) {
        throw Error(solver, "the tolerance must be 1e-14 to 0.1 of the reach", numberText(options.tolerance));
    }
    requireRange(solver, "mostIterations", options.mostIterations, 0, 1'000'000);
    if (!(options.largestStep > 0 && options.largestStep <= 180)) {
        throw Error(solver, "largestStep must be above 0 and at most 180 degrees", numberText(options.largestStep));
    }
}

void requireWithinLimits(const JointTree& tree, std::span<const double> degrees) {
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const Joint& joint = tree.joints()[i];
        if (joint.kind == JointKind::fixed || (degrees[i] >= joint.least && degrees[i] <= joint.most)) continue;
        throw Error(solver,
                    "the angle of joint " + std::to_string(i) + " must be " + numberText(joint.least) + " to " +
                        numberText(joint.most),
                    numberText(degrees[i]));
    }
}

}  // namespace

IkResult solveInverseKinematics(const JointTree& tree, const EndEffector& end, const vec3& target,
                                std::span<const double> start, const IkOptions& options) {
    tree.requireEnd(end);
    tree.requireAngles(start);
    requireWithinLimits(tree, start);
    requireOptions(options);
    requireFinite(solver, "the target", target);
    if (largestComponent(target) > 1e100) {
        throw Error(solver, "the target must have coordinates of at most 1e100", vectorText(target));
    }

    const IkChain chain(tree, end, start);
    const vec3 toTarget = target - chain.root();
    const auto [goal, isProjected] = chain.goalOf(toTarget, chain.poseOf(chain.startDegrees()).end, options.tolerance);
    Search search(chain, goal, options);
    IkResult result;
    const auto record = [&](double largestStep) {
        result.history.push_back({chain.inWorld(search.residual()), largestStep});
    };
    record(0);
    const double tolerance = options.tolerance * chain.reach();
    bool isStalled = false;
    while (search.residual() > tolerance && !isStalled && std::ssize(result.history) <= options.mostIterations) {
        const auto step = search.iterate();
        if (step) record(*step);
        const std::size_t count = result.history.size();
        isStalled = !step || (count > stallWindow && result.history[count - 1].residual >
                                                         stallRatio * result.history[count - 1 - stallWindow].residual);
    }

    const bool isThere = search.residual() <= tolerance;
    result.end = isProjected ? (isThere ? IkEnd::atEdge : IkEnd::outOfReach)
                 : isThere   ? IkEnd::reached
                 : isStalled ? IkEnd::stalled
                             : IkEnd::notYetThere;
    result.goal = isProjected ? chain.root() + chain.inWorld(goal) : target;
    const vec3 missing = toTarget - chain.inWorld(search.end());
    result.distance = std::hypot(missing.x, missing.y, missing.z);
    result.degrees.assign(start.begin(), start.end());
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const double angle = search.angles()[i];
        result.degrees[chain.indexInTree(i)] = angle;
        if (angle == chain.link(i).least || angle == chain.link(i).most) result.atLimit.push_back(chain.indexInTree(i));
    }
    return result;
}

}  // namespace mv
