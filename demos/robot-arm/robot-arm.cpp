// robot-arm: from the angles of joints to where the hand is (forward kinematics) and back (inverse kinematics).
#include "robot-arm.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/motion/two_link.h"

namespace mv::robot_arm {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofScene{drawLinks, drawLinks, drawWalkers, drawPerson};  // walker.cpp, person.cpp
    gpu.overlay.begin(frame);
    ofScene.at(static_cast<std::size_t>(s.which))(gpu, s, frame);
    gpu.overlay.above.draw(frame);
}

// Draw two links, or the arm.
void drawLinks(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Find the angles. Forward kinematics is given them, inverse kinematics computes those that bring the end to the target
    const Jointed thing = thingOf(s);
    const IkResult found = find(s, thing, frame.index());

    // Multiply the matrices of the joints. The products place the parts
    const std::vector<mat4> worldFromPart = worldFromParts(thing.tree, found.degrees);

    // Draw the parts, which hide the ghosts, and are under the words
    const Pane pane = paneOf(s, frame);
    gpu.overlay.look(paneOf(s, frame.inUnits()), clipFromWorldOf(s, pane));
    showLinks(gpu.overlay, s, thing, found, worldFromPart, frame.inUnits());
    beginParts(gpu, frame);
    drawParts(gpu, pane, thing, worldFromPart);
    if (isArm(s)) drawTable(gpu);
    glViewport(0, 0, frame.width(), frame.height());
}

// Forward kinematics: the matrix of a part is its parent's matrix times its own, a product along the tree.
std::vector<mat4> worldFromParts(const JointTree& tree, const Angles& angles) {
    std::vector<mat4> worldFromPart;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const auto parent = tree.joints()[i].parent;
        const mat4 parentFromPart = tree.parentFromTurned(i, angles[i]);
        worldFromPart.push_back(parent ? worldFromPart[*parent] * parentFromPart : parentFromPart);
    }
    return worldFromPart;
}

// The angles of frame i: those of the start plus i times the rates. The angle is a product, not a sum over frames.
Angles anglesAt(const Settings& s, int i) {
    const auto& [theta1, theta2, rate1, rate2] = s.links;
    if (isArm(s)) return {s.arm.turn, s.arm.shoulder, s.arm.elbow, s.arm.wrist};
    return {theta1 + i * rate1, theta2 + i * rate2};
}

// Inverse kinematics: the angles for a target of the end, by a formula, or step by step from the start's angles.
IkResult find(const Settings& s, const Jointed& thing, int index) {
    if (iterates(s)) return byIteration(thing, anglesAt(s, 0), targetOf(s), s.iterations, s.method);
    IkResult known;
    known.degrees = isForward(s) ? anglesAt(s, index) : byFormula(s, vec2(targetOf(s)), 1);
    return known;
}

// The angles of two links, with the elbow turned counter-clockwise (0) or clockwise (1).
Angles byFormula(const Settings& s, const vec2& to, std::size_t side) {
    const TwoLinkAngles found = twoLinkAngles(s.upper, s.lower, to).angles.at(side);
    return {found.shoulder, found.elbow};
}

IkResult byIteration(const Jointed& thing, const Angles& start, const vec3& to, int most, Method by) {
    static constexpr std::array<IkMethod, 3> methods{IkMethod::cyclicCoordinateDescent, IkMethod::jacobianTranspose,
                                                     IkMethod::dampedLeastSquares};
    const IkMethod ours = methods.at(static_cast<std::size_t>(by) - static_cast<std::size_t>(Method::ccd));
    return solveInverseKinematics(thing.tree, thing.end, to, start, {.method = ours, .mostIterations = most});
}

Jointed thingOf(const Settings& s) {
    return isArm(s) ? arm(s.upper, s.lower, s.arm.limits) : twoLinks(s.upper, s.lower);
}

vec3 targetOf(const Settings& s) {
    const vec3 at(s.target.x, s.target.y, isArm(s) ? s.target.z : 0);
    if (s.beyond == 0) return at;
    const vec3 direction = glm::length(at) > 0 ? glm::normalize(at) : vec3(1, 0, 0);
    return (legOf(s) + (isArm(s) ? armHand : 0) + s.beyond) * direction;
}

// Draw each part: a few boxes, placed by its matrix, and a cylinder for its joint.
void drawParts(Gpu& gpu, const Pane& pane, const Jointed& thing, const std::vector<mat4>& worldFromPart) {
    glViewport(pane.x, pane.y, pane.width, pane.height);
    for (std::size_t i = 0; i < thing.parts.size(); ++i) {
        const JointedPart& part = thing.parts[i];
        if (!part.jointFromBox.empty()) gpu.program.set("color", part.color);
        for (const mat4& jointFromBox : part.jointFromBox) {
            gpu.program.set("worldFromModel", worldFromPart[i] * jointFromBox);
            gpu.box.draw();
        }
        const Joint& joint = thing.tree.joints()[i];
        // A joint that turns a part about its own length has no pin
        if (joint.kind == JointKind::fixed || joint.axis.x != 0) continue;
        gpu.program.set("color", vec3(0.32));
        const mat4 jointFromCylinder = (joint.axis.y == 0 ? rotateX(90) : mat4(1)) * scale(0.11, 0.2, 0.11);
        gpu.program.set("worldFromModel", worldFromPart[i] * jointFromCylinder);
        gpu.cylinder.draw();
    }
}

// Draw the figures that parts hide, and set the camera of the parts.
void beginParts(Gpu& gpu, const Frame& frame) {
    gpu.overlay.below.draw(frame);
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    gpu.program.set("clipFromWorld", gpu.overlay.clipFromWorld());
}

void drawTable(Gpu& gpu) {
    gpu.program.set("color", vec3(robotEarth));
    gpu.program.set("worldFromModel", translate(-1.6, table - 0.05, 0) * scale(3.2, 0.1, 2.4));
    gpu.box.draw();
    gpu.program.set("worldFromModel", translate(0, table / 2 - 0.05, 0) * scale(0.2, -table - 0.1, 0.2));
    gpu.cylinder.draw();
}

mat4 clipFromWorldOf(const Settings& s, const Pane& pane) {
    const double narrow = std::max(1.0, 1 / pane.aspect()), half = 1.3 * legOf(s) * narrow;
    if (isLinks(s)) return ortho(-half * pane.aspect(), half * pane.aspect(), -half, half, -5, 5);
    const mat4 viewFromWorld = lookAt(vec3(1.6, 2.4, 6.6), vec3(0, 0.55, 0), vec3(0, 1, 0));
    const double fovy = 2 * degrees(std::atan(0.325 * narrow));
    return perspective(fovy, pane.aspect(), 0.5, 60) * seenFrom(s.arm.orbit, viewFromWorld);
}

}  // namespace mv::robot_arm
