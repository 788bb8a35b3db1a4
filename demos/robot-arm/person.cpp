// A whole figure. Its joints are driven by curves through the angles of a few poses.
#include <algorithm>
#include <cmath>
#include <string>

#include "body.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/motion/curve.h"
#include "robot-arm.h"

namespace mv::robot_arm {
namespace {

// "near forearm", "trunk"
std::string partName(const Jointed& thing, std::size_t part) {
    std::string name = thing.parts[part].name;
    name[0] = char(name[0] - 'A' + 'a');
    constexpr std::size_t limbs = 2;
    if (part < limbs) return name;
    const bool isNear = part < 5 || part == 8 || part == 9;
    return (isNear ? "near " : "far ") + name;
}

mat4 clipFromPerson(const Settings& s, const Pane& pane) {
    const double size = legOf(s), narrow = std::max(1.0, 1 / pane.aspect());
    const mat4 viewFromWorld = lookAt(size * vec3(2.2, 1.3, 3), size * vec3(0, 0.82, 0), vec3(0, 1, 0));
    return perspective(2 * degrees(std::atan(0.34 * narrow)), pane.aspect(), 0.2 * size, 40 * size) *
           seenFrom(s.arm.orbit, viewFromWorld);
}

}  // namespace

void drawPerson(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Find the angles of this time, and multiply the matrices along the tree
    Jointed thing = person(s.upper, s.lower);
    const Angles angles = personAngles(s, cyclesAt(frame.index()));
    const std::vector<mat4> worldFromPart = worldFromParts(thing.tree, angles);

    // Find the parts that are in each other. No curve through poses knows of them
    const Pane pane = paneOf(s, frame);
    gpu.overlay.look(paneOf(s, frame.inUnits()), clipFromPerson(s, pane));
    gpu.overlay.say(s.person.between == Between::spline ? "a spline through each angle of the poses"
                                                        : "straight from pose to pose");
    for (const auto& [one, other] : inEachOther(thing, worldFromPart)) {
        const std::string words = "The " + partName(thing, other) + " passes through the " + partName(thing, one) + ".";
        gpu.overlay.say(words, robotRed);
        frame.say(words);
        for (const std::size_t part : {one, other}) thing.parts[part].color = vec3(robotRed);
    }

    // Draw the parts, and the ground
    beginParts(gpu, frame);
    drawParts(gpu, pane, thing, worldFromPart);
    gpu.program.set("color", vec3(robotEarth));
    gpu.program.set("worldFromModel", scale(legOf(s)) * translate(-0.9, -0.06, 0) * scale(1.8, 0.04, 1.2));
    gpu.box.draw();
    if (s.matrices)
        gpu.overlay.product(frame.inUnits(), thing, worldFromPart, angles, besideOf(s, frame.inUnits()), false);
    glViewport(0, 0, frame.width(), frame.height());
}

// The angles of all joints at a time: for each joint a closed curve of its own, through its angles in the poses.
Angles personAngles(const Settings& s, double cycles) {
    Angles angles;
    for (const Curve<double>& curve : curvesOf(s)) angles.push_back(curve.position(cycles));
    return angles;
}

std::vector<Curve<double>> curvesOf(const Settings& s) {
    std::vector<std::vector<double>> poses = posesOf(s.person.routine);
    poses.push_back(poses.front());
    std::vector<Curve<double>> curves;
    for (std::size_t joint = 0; joint < poses.front().size(); ++joint) {
        std::vector<Keyframe<double>> keys;
        for (std::size_t i = 0; i < poses.size(); ++i)
            keys.push_back({double(i) / double(poses.size() - 1), poses[i][joint]});
        curves.push_back(s.person.between == Between::spline ? Curve<double>::periodicSpline(keys)
                                                             : Curve<double>::linear(keys, Ends::closed));
    }
    return curves;
}

// Frame 0 is a quarter of a cycle after the first pose.
double cyclesAt(int index) { return double(index) / cycleFrames + 0.25; }

}  // namespace mv::robot_arm
