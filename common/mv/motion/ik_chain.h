// The part of a tree that inverse kinematics works on: the joints of one path that turn, in units of about their reach.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mv/math/types.h"
#include "mv/motion/joint_tree.h"

namespace mv {

// The parts between two joints that turn are one link. Positions count from the first such joint, so that
// neither a place far from the origin nor a size costs digits. `tree`, `end` and `degrees` are checked before.
class IkChain {
  public:
    IkChain(const JointTree& tree, const EndEffector& end, std::span<const double> degrees);

    struct Link {
        mat4 before;  // from this joint's space to that of the one before, but for its turn
        vec3 axis;
        double least, most;
    };
    std::size_t size() const { return links_.size(); }
    const Link& link(std::size_t i) const { return links_[i]; }
    std::size_t indexInTree(std::size_t i) const { return index_[i]; }
    const std::vector<double>& startDegrees() const { return degrees_; }

    // The places of the joints and the end, and the joints' axes.
    struct Pose {
        std::vector<vec3> origins, axes;
        vec3 end{0};
    };
    Pose poseOf(const std::vector<double>& degrees) const;

    // The goal for a target: itself, or where it is projected to. `target` is in world units, from the root: in those
    // of a tiny chain it might overflow. The tolerance is a part of the reach.
    struct Goal {
        vec3 position;
        bool isProjected;
    };
    Goal goalOf(const vec3& target, const vec3& endNow, double tolerance) const;

    // The sum of the links' lengths: from 1 to 2, or 0.
    double reach() const { return reach_; }

    // The first joint's place in world space, and a vector or a length of the chain in world units.
    const vec3& root() const { return root_; }
    vec3 inWorld(const vec3& v) const;
    double inWorld(double length) const;

  private:
    void scaleToReach();

    std::vector<Link> links_;
    std::vector<std::size_t> index_;
    std::vector<double> degrees_;
    vec3 root_{0}, tip_{0};
    int exponent_ = 0;  // a unit is 2^exponent_ of the world's
    double reach_ = 0, longest_ = 0;
};

}  // namespace mv
