// A whole figure for lessons on kinematics: trunk, head, arms and legs on a tree of joints, the poses that it goes through, and
// which of its parts are in each other.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "jointed.h"

namespace mv {

// Joint 0 is the trunk, which does not turn; 1 is the head; 2 to 4 are shoulder, twist and elbow of the near arm, 5 to 7 of the far
// arm; 8 and 9 are hip and knee of the near leg, 10 and 11 of the far leg. The feet stand at y = 0 and the figure looks along
// x; the near side is z > 0. The end is the near hand. All lengths go with the legs'.
Jointed person(double thigh, double shank);

// What the figure does over and over: some poses, each for all joints, evenly spread over a cycle.
enum class Routine { walk, handThrough, handAround };
std::vector<std::vector<double>> posesOf(Routine routine);

// The pairs of parts whose first boxes have points in common, but for those that hang together at a joint. Both boxes are as they are
// drawn: turned, not the boxes along the axes that hold them. Touching is none.
// Source: Gottschalk, Lin and Manocha, "OBBTree" (1996): boxes are apart if they are along one of 15 directions.
std::vector<std::pair<std::size_t, std::size_t>> inEachOther(const Jointed& thing,
                                                             const std::vector<mat4>& worldFromPart);

}  // namespace mv
