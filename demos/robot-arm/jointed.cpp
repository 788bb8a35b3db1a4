#include "jointed.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "mv/error.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

const vec3 blue(0.30, 0.50, 0.80), orange(0.95, 0.62, 0.22), green(0.22, 0.65, 0.50), steel(0.64, 0.66, 0.70);
constexpr std::array<NumberRange, 4> armRanges{armTurn, armShoulder, armElbow, armWrist};

JointedPart bar(const std::string& name, const std::string& angle, const vec3& color, double length, double width) {
    return {name, angle, color, {scale(length, width, width)}};
}

}  // namespace

Jointed twoLinks(double upper, double lower) {
    return {JointTree({{}, {.parent = 0, .parentFromJoint = translate(upper, 0, 0)}}),
            {bar("Upper", "θ1", blue, upper, 0.16),
             {"Lower", "θ2", orange, {translate(0, 0, 0.16) * scale(lower, 0.11, 0.16)}}},  // before the first
            {1, {lower, 0, 0}}};
}

Jointed arm(double upper, double lower, bool hasLimits) {
    const std::array<double, 4> along{0, 0, upper, lower};
    std::vector<Joint> joints(4);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (i > 0) joints[i].parent = i - 1;
        joints[i].parentFromJoint = translate(along[i], 0, 0);
        if (!hasLimits) continue;
        joints[i].least = armRanges[i].low;
        joints[i].most = armRanges[i].high;
    }
    joints[0].axis = {0, 1, 0};

    JointedPart hand = bar("Hand", "wrist", green, 0.2, 0.1);
    for (const double side : {-0.08, 0.08}) {  // the gripper
        hand.jointFromBox.push_back(translate(0.16, 0, side) * scale(armHand - 0.16, 0.06, 0.04));
    }
    return {JointTree(joints),
            {{"Turret", "turn", steel},
             bar("Upper", "shoulder", blue, upper, 0.16),
             bar("Lower", "elbow", orange, lower, 0.12),
             hand},
            {3, {armHand, 0, 0}}};
}

std::vector<double> armStart(int k) {
    if (k < 0) throw Error("armStart", "k must be 0 or more", numberText(k));
    constexpr double root = 1.16730397826141868;  // of x^5 = x + 1
    std::vector<double> degrees;
    double factor = 1;
    for (const NumberRange& range : armRanges) {
        factor /= root;
        degrees.push_back(range.low + (range.high - range.low) * std::fmod(0.5 + (k + 1) * factor, 1));
    }
    return degrees;
}

Jointed legs(double upper, double lower, const vec2& hip) {
    const double size = upper + lower;
    const mat4 upright = rotateZ(90);
    std::vector<Joint> joints{{.parentFromJoint = translate(hip.x, hip.y, 0), .kind = JointKind::fixed}};
    std::vector<JointedPart> parts{{"Body",
                                    "",
                                    steel,
                                    {upright * scale(0.28 * size, 0.10 * size, 0.3),
                                     upright * translate(0.29 * size, 0.01 * size, 0) * scale(0.12 * size)}}};
    for (const double side : {1.0, -1.0}) {
        const double shade = side > 0 ? 1 : 0.6;
        const std::size_t thigh = joints.size();
        joints.push_back({.parent = 0, .parentFromJoint = translate(0, 0, legSide * side)});
        joints.push_back({.parent = thigh, .parentFromJoint = translate(upper, 0, 0)});
        parts.push_back(bar("Thigh", "hip", shade * blue, upper, 0.16));
        parts.push_back(bar("Shank", "knee", shade * orange, lower, 0.12));
    }
    return {JointTree(joints), parts, {2, {lower, 0, 0}}};
}

std::vector<vec3> stickOf(const Jointed& thing, const std::vector<mat4>& worldFromPart) {
    std::vector<vec3> points;
    for (const std::size_t i : thing.tree.pathTo(thing.end.joint)) {
        if (!thing.parts[i].jointFromBox.empty()) points.emplace_back(worldFromPart[i][3]);
    }
    points.emplace_back(worldFromPart[thing.end.joint] * vec4(thing.end.offset, 1));
    return points;
}

}  // namespace mv
