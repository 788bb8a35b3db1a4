// Arms for the tests of mv/motion's kinematics.
#pragma once
#include <optional>
#include <vector>

#include "mv/math/transform.h"
#include "mv/motion/joint_tree.h"
#include "support/random.h"

namespace mv::test {

struct Arm {
    JointTree tree;
    EndEffector end;
};

// Links along x at rest that turn about z, from the origin.
inline Arm planeArm(const std::vector<double>& lengths) {
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (i == 0)
            joints.push_back({});
        else
            joints.push_back({.parent = i - 1, .parentFromJoint = translate(lengths[i - 1], 0, 0)});
    }
    return {JointTree(joints), {lengths.size() - 1, {lengths.back(), 0, 0}}};
}

// Joints in a row with links up to 1.7 long, turned anyhow, about any axes.
inline Arm randomArm(Random& random, std::size_t count) {
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < count; ++i) {
        const double degrees = random.number(-180, 180);
        const vec3 about = random.direction(), offset = random.point(1);
        const vec3 axis = random.logarithmic(0.1, 10) * random.direction();
        joints.push_back({.parent = i == 0 ? std::nullopt : std::optional(i - 1),
                          .parentFromJoint = translate(offset) * rotate(degrees, about),
                          .axis = axis});
    }
    return {JointTree(joints), {count - 1, random.point(1)}};
}

// Within the limits, or half a turn where there are none.
inline std::vector<double> randomAngles(Random& random, const JointTree& tree) {
    std::vector<double> angles;
    for (const Joint& joint : tree.joints()) {
        const double angle = random.number(std::max(joint.least, -180.0), std::min(joint.most, 180.0));
        angles.push_back(joint.kind == JointKind::fixed ? 0 : angle);
    }
    return angles;
}

}  // namespace mv::test
