// Jointed things for lessons on kinematics: their joints, and the parts on them.
//
// Every part lies along the x axis of its joint. Lengths are metres and must be above 0; angles are degrees.
#pragma once
#include <string>
#include <vector>

#include "mv/demo/word_list.h"
#include "mv/math/types.h"
#include "mv/motion/joint_tree.h"

namespace mv {

struct JointedPart {
    std::string name;   // in a matrix's name: "Upper"
    std::string angle;  // name of its joint's angle: "shoulder"; "" for a joint that does not turn
    vec3 color{0};
    // Boxes in the joint's space, made of one that is 1 long along x, from the joint on, and 1 wide.
    std::vector<mat4> jointFromBox = {};
};

// A tree, a part for each of its joints, and what is to be at a target: the hand, a foot.
struct Jointed {
    JointTree tree;
    std::vector<JointedPart> parts;
    EndEffector end;
};

// Two links in the plane z = 0, the first of them at the origin.
Jointed twoLinks(double upper, double lower);

// Ranges of the joints of the arm, in the order of its joints.
inline constexpr NumberRange armTurn{-160, 160}, armShoulder{0, 180}, armElbow{-150, 0}, armWrist{-90, 90};
inline constexpr double armHand = 0.4;  // from the wrist to between the tips of the gripper

// An arm whose shoulder is the origin: a turret turns about the vertical, y, and shoulder, elbow and wrist about z axes.
// The reach of its free joints is upper + lower + armHand: turret and shoulder are one place.
Jointed arm(double upper, double lower, bool hasLimits);

// Angles spread over these ranges; for k from 0 on they fill them ever more evenly. Source: Roberts, "The unreasonable
// effectiveness of quasirandom sequences" (2018). Refused: k < 0.
std::vector<double> armStart(int k);

// Two legs on a body, at its hip: joint 0 is the body, 1 and 2 the near leg (z = legSide), 3 and 4 the far leg. The end is
// the near foot.
inline constexpr double legSide = 0.25;
Jointed legs(double upper, double lower, const vec2& hip);

// The places in world space of the joints, from the root to the end, that have a part of some length, and of the end.
std::vector<vec3> stickOf(const Jointed& thing, const std::vector<mat4>& worldFromPart);

}  // namespace mv
