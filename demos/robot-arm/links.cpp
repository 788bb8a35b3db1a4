// The two links of robot-arm, in the plane.
#include <algorithm>

#include "mv/math/projection.h"
#include "robot-arm.h"

namespace mv::robot_arm {

static Jointed linksOf(const Settings& s) { return twoLinks(s.upper, s.lower); }

// The angles of frame i: those of the start plus i times the rates. The angle is a product, not a sum over frames.
static Angles linkAngles(const Settings& s, int i) {
    const auto& [theta1, theta2, rate1, rate2] = s.links;
    return {theta1 + i * rate1, theta2 + i * rate2};
}

static vec3 linkTarget(const Settings& s) { return beyondReach(s, vec3(s.target.x, s.target.y, 0), legOf(s)); }

static mat4 clipFromPlane(const Settings& s, const Pane& pane) {
    const double narrow = std::max(1.0, 1 / pane.aspect()), half = 1.3 * legOf(s) * narrow;
    return ortho(-half * pane.aspect(), half * pane.aspect(), -half, half, -5, 5);
}

const Limb limbOfLinks{linksOf, linkAngles, linkTarget, clipFromPlane};

}  // namespace mv::robot_arm
