// Between two poses: three angles against slerp and nlerp.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "path.h"
#include "shared/strip.h"

namespace mv::path {
namespace {

// Angles about x, y and z: those that give the pose, or those of another order that make the same pose.
vec3 anglesOf(const Pose& pose, EulerOrder order) {
    if (order == EulerOrder::yxz) return {pose.pitch, pose.yaw, pose.roll};
    return eulerAnglesOf(orientationOf(pose), order).degrees;
}

}  // namespace

// Draw each way of turning in a pane of its own.
void drawPoses(Gpu& gpu, const Settings& s, const Frame& frame) {
    const double t = betweenAt(s, frame);
    const Turnings turnings = turningsOf(s.poses);
    for (std::size_t way = 0; way < turnings.size(); ++way) {
        const Pane pane = posePane(frame, way);
        const mat4 worldFromCar = rotationMatrix(poseAt(s.poses, way, t)) * scale(0.08) * translate(0, -2, 0);
        glViewport(pane.x, pane.y, pane.width, pane.height);
        gpu.program.set("clipFromWorld", clipFromPoses(s, pane));
        gpu.program.set("worldFromModel", worldFromCar);
        gpu.car.draw();
        showPose(gpu.drawing, s, way, turnings.at(way), frame.inUnits());
    }
    tellLock(s.poses, frame);
    showTurnings(gpu.drawing, turnings, frame.inUnits());
}

// The pose at part t between two poses: mix three angles (0), or quaternions on the sphere (1) or straight through it (2).
quat poseAt(const Poses& poses, std::size_t way, double t) {
    const quat from = orientationOf(poses.from), to = orientationOf(poses.to);
    if (way == 1) return slerp(from, to, t);
    if (way == 2) return nlerp(from, to, t);
    return quatFromEuler(anglesAt(poses, t), poses.order);
}
vec3 anglesAt(const Poses& poses, double t) {
    return glm::mix(anglesOf(poses.from, poses.order), anglesOf(poses.to, poses.order), t);
}
quat orientationOf(const Pose& pose) { return quatFromYawPitchRoll(pose.yaw, pose.pitch, pose.roll); }

Turnings turningsOf(const Poses& poses) {
    Turnings turnings;
    for (std::size_t way = 0; way < turnings.size(); ++way)
        turnings.at(way) = turningOf([&](double t) { return poseAt(poses, way, t); });
    return turnings;
}

// The part t over time: from 0 to 1 and back in eight seconds.
double betweenAt(const Settings& s, const FrameInfo& frame) {
    return 1 - std::abs(1 - std::fmod(s.start / 100 + frame.time() / 4, 2));
}

Pane posePane(const FrameInfo& frame, std::size_t way) {
    return paneAboveStrip(frame, double(way) / 3, double(way + 1) / 3);
}
mat4 clipFromPoses(const Settings& s, const Pane& pane) {
    const double half = 1.2 * std::max(1.0, 1 / pane.aspect());  // of the world, 5 before the eye
    return perspective(2 * degrees(std::atan(half / 5)), pane.aspect(), 1, 20) *
           lookAt(vec3(4.2, 2, 1.8), vec3(0), worldUp) * spinOf(s);
}

}  // namespace mv::path
