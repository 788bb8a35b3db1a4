// robot-arm: from the angles of joints to where the hand is (forward kinematics) and back (inverse kinematics).
#include "robot-arm.h"

#include <array>
#include <glm/geometric.hpp>

#include "mv/gl/functions.h"
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

// Forward kinematics is given the angles. Inverse kinematics finds those for a target of the end, by a formula, or step by
// step from the start's angles.
static IkResult givenAngles(const Settings& s, const Jointed&, int index) {
    IkResult given;
    given.degrees = anglesAt(s, index);
    return given;
}
static IkResult foundByFormula(const Settings& s, const Jointed&, int) {
    IkResult found;
    found.degrees = byFormula(s, vec2(targetOf(s)), 1);
    return found;
}
static IkResult foundByIteration(const Settings& s, const Jointed& thing, int) {
    return byIteration(thing, anglesAt(s, 0), targetOf(s), s.iterations, s.method);
}
IkResult find(const Settings& s, const Jointed& thing, int index) {
    constexpr std::array ofMethod{givenAngles, foundByFormula, foundByIteration, foundByIteration,
                                  foundByIteration};  // in the order of Method
    return ofMethod.at(std::size_t(s.method))(s, thing, index);
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

// Two links and the arm have joints, angles, a target and a camera of their own: links.cpp, arm.cpp.
static const Limb& limbOf(const Settings& s) {
    static constexpr std::array limbs{&limbOfLinks, &limbOfArm, &limbOfLinks, &limbOfLinks};  // in the order of Which
    return *limbs.at(std::size_t(s.which));
}
Jointed thingOf(const Settings& s) { return limbOf(s).thing(s); }
Angles anglesAt(const Settings& s, int index) { return limbOf(s).anglesAt(s, index); }
vec3 targetOf(const Settings& s) { return limbOf(s).target(s); }
mat4 clipFromWorldOf(const Settings& s, const Pane& pane) { return limbOf(s).clipFromWorld(s, pane); }

// The target itself, or one that lies so far beyond the reach in its direction.
vec3 beyondReach(const Settings& s, const vec3& target, double reach) {
    if (s.beyond == 0) return target;
    const vec3 direction = glm::length(target) > 0 ? glm::normalize(target) : vec3(1, 0, 0);
    return (reach + s.beyond) * direction;
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

}  // namespace mv::robot_arm
