#include "body.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/math/transform.h"

namespace mv {
namespace {

const vec3 skin(0.93, 0.76, 0.62), shirt(0.30, 0.50, 0.80), trousers(0.38, 0.40, 0.46);

// Degrees, in the order of the joints of person().
using Pose = std::vector<double>;

// A limb that lies along the x axis of its joint.
JointedPart limb(const std::string& name, const std::string& angle, const vec3& color, double length, double width) {
    return {name, angle, color, {scale(length, width, width)}};
}

// The near side's pose and the far side's: arm (shoulder, twist, elbow), then leg (hip, knee).
struct Side {
    double shoulder = -90, twist = 0, elbow = 10, hip = -90, knee = 0;
};
Pose poseOf(double neck, const Side& near, const Side& far) {
    return {0,         neck,      near.shoulder, near.twist, near.elbow, far.shoulder,
            far.twist, far.elbow, near.hip,      near.knee,  far.hip,    far.knee};
}

// A box as its middle and half of each of its edges; the one of jointFromBox goes from 0 to 1 along x.
struct Box3 {
    vec3 middle;
    std::array<vec3, 3> half;
};
Box3 boxOf(const mat4& worldFromBox) {
    return {worldFromBox * vec4(0.5, 0, 0, 1),
            {vec3(worldFromBox[0]) / 2.0, vec3(worldFromBox[1]) / 2.0, vec3(worldFromBox[2]) / 2.0}};
}

bool areApartAlong(const Box3& a, const Box3& b, const vec3& direction) {
    double reach = 0;
    for (const vec3& half : a.half) reach += std::abs(glm::dot(half, direction));
    for (const vec3& half : b.half) reach += std::abs(glm::dot(half, direction));
    return std::abs(glm::dot(b.middle - a.middle, direction)) >= reach && reach > 0;
}

bool areApart(const Box3& a, const Box3& b) {
    for (const vec3& edge : a.half) {
        if (areApartAlong(a, b, edge)) return true;
    }
    for (const vec3& edge : b.half) {
        if (areApartAlong(a, b, edge)) return true;
    }
    for (const vec3& one : a.half) {
        for (const vec3& other : b.half) {
            // Nearly parallel edges make no direction of their own: those of the faces above tell it
            const vec3 across = glm::cross(one, other);
            if (glm::length(across) < 1e-9 * glm::length(one) * glm::length(other)) continue;
            if (areApartAlong(a, b, across)) return true;
        }
    }
    return false;
}

}  // namespace

Jointed person(double thigh, double shank) {
    const double size = thigh + shank;
    const mat4 upright = rotateZ(90);
    std::vector<Joint> joints{{.parentFromJoint = translate(0, size, 0), .kind = JointKind::fixed},
                              {.parent = 0, .parentFromJoint = translate(0, 0.62 * size, 0)}};
    std::vector<JointedPart> parts{
        {"Trunk", "", shirt, {upright * scale(0.6 * size, 0.16 * size, 0.34 * size)}},
        {"Head",
         "neck",
         skin,
         {upright * translate(0.05 * size, 0, 0) * scale(0.22 * size, 0.17 * size, 0.15 * size),
          upright * scale(0.06 * size, 0.07 * size, 0.07 * size)}}};
    for (const double side : {1.0, -1.0}) {
        const double shade = side > 0 ? 1 : 0.75;
        const std::size_t shoulder = joints.size();
        joints.push_back({.parent = 0, .parentFromJoint = translate(0, 0.55 * size, 0.225 * size * side)});
        joints.push_back({.parent = shoulder, .parentFromJoint = mat4(1), .axis = {1, 0, 0}});
        joints.push_back({.parent = shoulder + 1, .parentFromJoint = translate(0.34 * size, 0, 0)});
        parts.push_back({"Shoulder", "shoulder", shade * shirt});
        parts.push_back(limb("Arm", "twist", shade * shirt, 0.34 * size, 0.09 * size));
        parts.push_back(limb("Forearm", "elbow", shade * skin, 0.36 * size, 0.07 * size));
    }
    for (const double side : {1.0, -1.0}) {
        const double shade = side > 0 ? 1 : 0.75;
        const std::size_t hip = joints.size();
        joints.push_back({.parent = 0, .parentFromJoint = translate(0, 0, 0.095 * size * side)});
        joints.push_back({.parent = hip, .parentFromJoint = translate(thigh, 0, 0)});
        parts.push_back(limb("Thigh", "hip", shade * trousers, thigh, 0.13 * size));
        parts.push_back(limb("Shank", "knee", shade * trousers, shank, 0.10 * size));
        // The foot, at a right angle
        parts.back().jointFromBox.push_back(translate(shank - 0.04 * size, 0, 0) * rotateZ(90) *
                                            translate(-0.06 * size, 0, 0) *
                                            scale(0.26 * size, 0.08 * size, 0.10 * size));
    }
    return {JointTree(joints), parts, {4, {0.36 * size, 0, 0}}};
}

std::vector<Pose> posesOf(Routine routine) {
    if (routine == Routine::walk) {
        // Of a side: the foot comes down before the body, is under it, leaves the ground behind it, swings
        const std::array<Side, 4> steps{
            {{-118, 0, 20, -66, -5}, {-94, 0, 18, -90, -6}, {-66, 0, 38, -112, -18}, {-90, 0, 26, -76, -62}}};
        std::vector<Pose> poses;
        for (std::size_t i = 0; i < 4; ++i)
            poses.push_back(poseOf(i % 2 == 0 ? 3 : -3, steps.at(i), steps.at((i + 2) % 4)));
        return poses;
    }
    // The near forearm lies across: before the belly, and behind the back. Around, the elbow opens first
    const auto arm = [](double shoulder, double elbow) {
        return poseOf(0, {.shoulder = shoulder, .twist = -90, .elbow = elbow}, {});
    };
    const Pose before = arm(-50, 90), behind = arm(-130, 90);
    if (routine == Routine::handThrough) return {before, behind};
    const Pose front = arm(-50, 0), hanging = arm(-90, 0), back = arm(-130, 0);
    return {before, front, hanging, back, behind, back, hanging, front};
}

std::vector<std::pair<std::size_t, std::size_t>> inEachOther(const Jointed& thing,
                                                             const std::vector<mat4>& worldFromPart) {
    // The joint that a part with boxes hangs on, over those without
    const auto holder = [&](std::size_t part) {
        auto parent = thing.tree.joints()[part].parent;
        while (parent && thing.parts[*parent].jointFromBox.empty()) parent = thing.tree.joints()[*parent].parent;
        return parent;
    };
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < thing.parts.size(); ++i) {
        for (std::size_t j = i + 1; j < thing.parts.size(); ++j) {
            if (thing.parts[i].jointFromBox.empty() || thing.parts[j].jointFromBox.empty() || holder(j) == i) continue;
            const Box3 a = boxOf(worldFromPart[i] * thing.parts[i].jointFromBox.front()),
                       b = boxOf(worldFromPart[j] * thing.parts[j].jointFromBox.front());
            if (!areApart(a, b)) pairs.emplace_back(i, j);
        }
    }
    return pairs;
}

}  // namespace mv
