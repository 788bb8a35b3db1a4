// Turns from one pose to another on a sphere: the path of a thing's nose, and the speed of its turn.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "mv/gl/drawing.h"
#include "mv/motion/orientation.h"

namespace mv {

// A turn for t from 0 to 1, by 180 equal steps of t.
struct Turning {
    std::vector<vec3> nose, roof;  // where -z and y go, on the unit sphere
    std::vector<vec2> speeds;      // degrees for each unit of t, as means over each step, at its middle
    double whole = 0;              // degrees in all
    double slowest = 0, fastest = 0;
};
Turning turningOf(const std::function<quat(double t)>& poseAt);

// A line on the unit sphere. Its part behind the sphere is fainter.
void drawOnSphere(Drawing& drawing, const mat4& clipFromWorld, const std::vector<vec3>& points, const Stroke& stroke);
// The sphere's own lines, the ways of nose (in this colour) and roof (grey), and where they begin and end.
void drawTurning(Drawing& drawing, const mat4& clipFromWorld, const Turning& turning, const vec4& color);

// Gimbal rings at these angles. The outer ring turns about the upright axis of yaw and holds that of pitch; the inner one turns
// about pitch and holds that of roll, the nose's. Colours of the axes of pitch, yaw and roll.
void drawGimbal(Drawing& drawing, const mat4& clipFromWorld, const YawPitchRoll& angles,
                const std::array<vec4, 3>& colors);

}  // namespace mv
