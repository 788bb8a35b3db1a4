#include "mv/motion/ik_chain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/math/robust.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// How far inside its reach an arm is sent for what is out of it, as a part of the reach.
constexpr double inset = 1e-3;

}  // namespace

IkChain::IkChain(const JointTree& tree, const EndEffector& end, std::span<const double> degrees) {
    mat4 between(1);  // since the last joint that turns
    for (const std::size_t i : tree.pathTo(end.joint)) {
        const Joint& joint = tree.joints()[i];
        between = between * joint.parentFromJoint;
        if (joint.kind == JointKind::fixed) continue;
        links_.push_back({between, joint.axis, joint.least, joint.most});
        index_.push_back(i);
        between = mat4(1);
    }
    tip_ = vec3(between * vec4(end.offset, 1));
    if (links_.empty()) {
        root_ = std::exchange(tip_, vec3(0));
    } else {
        root_ = vec3(links_[0].before[3]);
        links_[0].before[3] = vec4(0, 0, 0, 1);
    }
    scaleToReach();
    for (const std::size_t i : index_) degrees_.push_back(degrees[i]);
}

void IkChain::scaleToReach() {
    double sum = std::hypot(tip_.x, tip_.y, tip_.z);
    for (const Link& link : links_) sum += std::hypot(link.before[3].x, link.before[3].y, link.before[3].z);
    if (sum == 0) return;
    exponent_ = std::ilogb(sum);
    tip_ = timesPowerOfTwo(tip_, -exponent_);
    reach_ = longest_ = glm::length(tip_);
    for (Link& link : links_) {
        const vec3 offset = timesPowerOfTwo(vec3(link.before[3]), -exponent_);
        link.before[3] = vec4(offset, 1);
        const double length = glm::length(offset);
        reach_ += length;
        longest_ = std::max(longest_, length);
    }
}

IkChain::Pose IkChain::poseOf(const std::vector<double>& degrees) const {
    Pose pose;
    pose.origins.reserve(links_.size());
    pose.axes.reserve(links_.size());
    mat4 fromRoot(1);
    for (std::size_t i = 0; i < links_.size(); ++i) {
        fromRoot = fromRoot * (links_[i].before * rotate(degrees[i], links_[i].axis));
        pose.origins.emplace_back(fromRoot[3]);
        pose.axes.push_back(mat3(fromRoot) * links_[i].axis);
    }
    pose.end = vec3(fromRoot * vec4(tip_, 1));
    return pose;
}

IkChain::Goal IkChain::goalOf(const vec3& target, const vec3& endNow, double tolerance) const {
    const double distance = std::hypot(target.x, target.y, target.z), hole = std::max(0.0, 2 * longest_ - reach_);
    const bool isFar = distance > inWorld(reach_ * (1 + tolerance));
    if (!isFar && distance >= inWorld(hole - tolerance * reach_)) {
        return {timesPowerOfTwo(target, -exponent_), false};
    }
    // Half the play at most, so that what is inside one bound is not beyond the other.
    const double margin = std::min(inset * reach_, std::max(0.0, reach_ - hole) / 2);
    // At the root any direction is right: that in which the end is now, since a hole keeps it off the root.
    const vec3 direction = unit(distance > 0 ? target : endNow);
    return {(isFar ? reach_ - margin : hole + margin) * direction, true};
}

vec3 IkChain::inWorld(const vec3& v) const { return timesPowerOfTwo(v, exponent_); }
double IkChain::inWorld(double length) const { return std::scalbn(length, exponent_); }

}  // namespace mv
