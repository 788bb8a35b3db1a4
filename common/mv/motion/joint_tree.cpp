#include "mv/motion/joint_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

constexpr std::string_view jointTree = "JointTree";
// Squares of coordinates up to this size, and sums of many, are numbers.
constexpr double largestJoint = 1e100;

std::string named(std::string_view what, std::size_t joint) {
    return std::string(what).append(" of joint ").append(std::to_string(joint));
}

void requireCoordinates(const std::string& name, const vec3& v) {
    requireFinite(jointTree, name, v);
    if (largestComponent(v) > largestJoint) {
        throw Error(jointTree, name + " must have coordinates of at most 1e100", vectorText(v));
    }
}

// The largest element of R^T R - I.
double shearOf(const mat3& m) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(glm::dot(m[i], m[k]) - (i == k ? 1 : 0)));
    }
    return worst;
}

void requireRigid(const mat4& m, std::size_t joint) {
    const std::string name = named("parentFromJoint", joint);
    requireFinite(jointTree, name, m);
    const mat3 turn(m);
    // Some dozens of products of rotations stay within 1e-12; a scale, a mirror, or what was a float matrix does not.
    const double shear = shearOf(turn);
    const bool isMirror = glm::dot(glm::cross(turn[0], turn[1]), turn[2]) < 0;
    const bool isAffine = vec4(m[0].w, m[1].w, m[2].w, m[3].w) == vec4(0, 0, 0, 1);
    if (!(shear <= 1e-12) || isMirror || !isAffine) {
        throw Error(jointTree, name + " must be a rotation and a translation, to 1e-12",
                    isMirror    ? "it mirrors"
                    : !isAffine ? "its last row is not (0, 0, 0, 1)"
                                : "its columns are off by " + numberText(shear));
    }
    requireCoordinates(name, vec3(m[3]));
}

void requireLimits(const Joint& joint, std::size_t index) {
    if (joint.least <= joint.most) return;  // false for NaN
    throw Error(jointTree, named("the limits", index) + " must be numbers, the least at most the most",
                numberText(joint.least) + " to " + numberText(joint.most));
}

}  // namespace

JointTree::JointTree(std::vector<Joint> joints) : joints_(std::move(joints)) {
    if (joints_.empty()) throw Error(jointTree, "a tree must have a joint", "none");
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        Joint& joint = joints_[i];
        if (joint.parent && *joint.parent >= i) {
            throw Error(jointTree, named("the parent", i) + " must come before it", std::to_string(*joint.parent));
        }
        requireRigid(joint.parentFromJoint, i);
        requireFinite(jointTree, named("the axis", i), joint.axis);
        if (joint.axis == vec3(0))
            throw Error(jointTree, named("the axis", i) + " must not be 0", vectorText(joint.axis));
        joint.axis = unit(joint.axis);
        requireLimits(joint, i);
    }
}

void JointTree::requireEnd(const EndEffector& end) const {
    if (end.joint >= joints_.size()) {
        throw Error(jointTree, "the end effector's joint must be 0 to " + std::to_string(joints_.size() - 1),
                    std::to_string(end.joint));
    }
    requireCoordinates("the end effector's offset", end.offset);
}

void JointTree::requireAngles(std::span<const double> degrees) const {
    if (degrees.size() != joints_.size()) {
        throw Error(jointTree, "there must be as many angles as joints, " + std::to_string(joints_.size()),
                    std::to_string(degrees.size()));
    }
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        requireFinite(jointTree, named("the angle", i), degrees[i]);
        if (joints_[i].kind == JointKind::fixed && degrees[i] != 0) {
            throw Error(jointTree, named("the angle", i) + ", which is fixed, must be 0", numberText(degrees[i]));
        }
    }
}

std::vector<std::size_t> JointTree::pathTo(std::size_t joint) const {
    requireEnd({joint});
    std::vector<std::size_t> path;
    for (std::optional<std::size_t> i = joint; i; i = joints_[*i].parent) path.push_back(*i);
    std::reverse(path.begin(), path.end());
    return path;
}

mat4 JointTree::parentFromTurned(std::size_t joint, double degrees) const {
    requireEnd({joint});
    const Joint& turned = joints_[joint];
    if (turned.kind == JointKind::revolute) return turned.parentFromJoint * rotate(degrees, turned.axis);
    if (degrees == 0) return turned.parentFromJoint;
    throw Error(jointTree, named("the angle", joint) + ", which is fixed, must be 0", numberText(degrees));
}

std::vector<mat4> JointTree::worldFromJoints(std::span<const double> degrees) const {
    requireAngles(degrees);
    std::vector<mat4> worldFromJoint;
    worldFromJoint.reserve(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const mat4 parentFromJoint = parentFromTurned(i, degrees[i]);
        const auto& parent = joints_[i].parent;
        worldFromJoint.push_back(parent ? worldFromJoint[*parent] * parentFromJoint : parentFromJoint);
    }
    return worldFromJoint;
}

vec3 JointTree::endPosition(std::span<const double> degrees, const EndEffector& end) const {
    requireEnd(end);
    requireAngles(degrees);
    // From the tip to the root the point alone is carried, which takes a quarter of the products of matrices.
    vec4 point(end.offset, 1);
    for (std::optional<std::size_t> i = end.joint; i; i = joints_[*i].parent) {
        point = parentFromTurned(*i, degrees[*i]) * point;
    }
    return vec3(point);
}

std::vector<vec3> JointTree::jacobianPerRadian(std::span<const double> degrees, const EndEffector& end) const {
    requireEnd(end);
    const std::vector<mat4> worldFromJoint = worldFromJoints(degrees);
    const vec3 position(worldFromJoint[end.joint] * vec4(end.offset, 1));
    std::vector<vec3> columns(joints_.size(), vec3(0));
    for (const std::size_t i : pathTo(end.joint)) {
        if (joints_[i].kind == JointKind::fixed) continue;
        // A joint's own turn leaves its axis where it is.
        const vec3 axis = mat3(worldFromJoint[i]) * joints_[i].axis;
        columns[i] = glm::cross(axis, position - vec3(worldFromJoint[i][3]));
    }
    return columns;
}

}  // namespace mv
