// The arm of robot-arm, on its table.
#include <algorithm>
#include <cmath>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "robot-arm.h"

namespace mv::robot_arm {

static Jointed armOf(const Settings& s) { return arm(s.upper, s.lower, s.arm.limits); }

static Angles armAngles(const Settings& s, int) { return {s.arm.turn, s.arm.shoulder, s.arm.elbow, s.arm.wrist}; }

static vec3 armTarget(const Settings& s) { return beyondReach(s, s.target, legOf(s) + armHand); }

static mat4 clipFromTable(const Settings& s, const Pane& pane) {
    const double narrow = std::max(1.0, 1 / pane.aspect());
    const mat4 viewFromWorld = lookAt(vec3(1.6, 2.4, 6.6), vec3(0, 0.55, 0), vec3(0, 1, 0));
    const double fovy = 2 * degrees(std::atan(0.325 * narrow));
    return perspective(fovy, pane.aspect(), 0.5, 60) * seenFrom(s.arm.orbit, viewFromWorld);
}

const Limb limbOfArm{armOf, armAngles, armTarget, clipFromTable};

void drawTable(Gpu& gpu) {
    gpu.program.set("color", vec3(robotEarth));
    gpu.program.set("worldFromModel", translate(-1.6, table - 0.05, 0) * scale(3.2, 0.1, 2.4));
    gpu.box.draw();
    gpu.program.set("worldFromModel", translate(0, table / 2 - 0.05, 0) * scale(0.2, -table - 0.1, 0.2));
    gpu.cylinder.draw();
}

}  // namespace mv::robot_arm
