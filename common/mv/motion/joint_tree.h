// A tree of joints, as a robot's arm and a skeleton are: where each part is for given angles (forward kinematics), and
// how a point of it moves with each angle (the Jacobian).
//
// Angles are degrees, one for each joint in the order of the joints. Matrices are rigid: a rotation and a translation,
// with coordinates up to 1e100; another matrix changes the size of what hangs on the joint, and belongs into what is
// drawn there.
#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mv/math/types.h"

namespace mv {

enum class JointKind { fixed, revolute };

struct Joint {
    std::optional<std::size_t> parent = {};  // an earlier joint; none: the joint stands in the world
    mat4 parentFromJoint{1};                 // at 0 degrees: where the joint is in its parent's space
    JointKind kind = JointKind::revolute;    // it turns about its axis, or not at all (a hand, a tool)
    vec3 axis{0, 0, 1};                      // in the joint's own space, through its origin; any length but 0
    // The angles that the joint may have, in degrees. Infinity is no limit.
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
};

// The point of which kinematics speaks: the hand's, the foot's. The end effector is fixed in the space of its joint.
struct EndEffector {
    std::size_t joint = 0;
    vec3 offset{0, 0, 0};
};

class JointTree {
  public:
    // Refused: no joint; a parent that does not come before its child, so that no joint is its own ancestor and one
    // pass finds all; a matrix that is not rigid to 1e-12 or has coordinates beyond 1e100; an axis 0; least above most;
    // NaN.
    explicit JointTree(std::vector<Joint> joints);

    const std::vector<Joint>& joints() const { return joints_; }

    // The joints from the root to this one, with both: those whose angles move what is fixed to it.
    std::vector<std::size_t> pathTo(std::size_t joint) const;

    // The joint's factor in the product along the tree: parentFromJoint * rotate(degrees, axis), of a fixed joint
    // parentFromJoint. Refused: NaN, infinity, and an angle other than 0 of a fixed joint. Limits are not asked.
    mat4 parentFromTurned(std::size_t joint, double degrees) const;

    // worldFromJoint of all joints: each is its parent's times its own factor, so the time is that of one product a
    // joint. Refused: another number of angles than of joints, and what parentFromTurned refuses.
    std::vector<mat4> worldFromJoints(std::span<const double> degrees) const;

    // The place of the end effector, in world space; only the path to it is evaluated. Refused: as worldFromJoints, no
    // such joint, an offset with coordinates beyond 1e100.
    vec3 endPosition(std::span<const double> degrees, const EndEffector& end) const;

    // The Jacobian of endPosition, one column a joint, in world units per RADIAN: axis x (end - joint) in world space,
    // and 0 for what does not move the end, which is a fixed joint, or one beside the path. Refuses what endPosition
    // refuses. Trap: per degree it is pi/180 of that. Source: Orin and Schrader, "Efficient computation of the Jacobian
    // for robot manipulators", Int. J. Robotics Research 3(4), 1984.
    std::vector<vec3> jacobianPerRadian(std::span<const double> degrees, const EndEffector& end) const;

    // Refuses an end effector that is not of this tree, as endPosition does.
    void requireEnd(const EndEffector& end) const;
    // Refuses angles of another number than the joints, NaN, infinity, and one other than 0 of a fixed joint.
    void requireAngles(std::span<const double> degrees) const;

  private:
    std::vector<Joint> joints_;
};

}  // namespace mv
