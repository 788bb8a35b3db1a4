#include "mv/geometry/light_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mv/error.h"
#include "mv/geometry/bounds.h"
#include "mv/math/require.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

constexpr const char* subject = "fitLightView";

Bounds boundsOfSeveral(std::span<const vec3> points) {
    if (points.empty()) throw Error(subject, "must have points to hold");
    Bounds box;
    for (const vec3& p : points) {
        requireFinite(subject, "each point", p);
        box.add(p);
    }
    if (box.low == box.high) throw Error(subject, "the points must not all be one", vectorText(points.front()));
    return box;
}

void requireMargin(double margin) {
    if (!(margin >= 0 && margin <= 0.4)) throw Error(subject, "the margin must be 0 to 0.4", numberText(margin));
}

// Widens low..high by `margin` of its width on each side; a width below `least` is made that first.
void widen(double& low, double& high, double margin, double least) {
    const double missing = std::max(0.0, least - (high - low));
    const double pad = margin * (high - low + missing) + missing / 2;
    low -= pad;
    high += pad;
}

// The points as seen from the light, divided by their distance along the gaze: x and y at distance 1, z the distance.
Bounds windowAtOne(const mat4& viewFromWorld, std::span<const vec3> points) {
    Bounds box;
    for (const vec3& p : points) {
        const vec3 seen(viewFromWorld * vec4(p, 1));
        const double distance = -seen.z;
        if (distance <= std::cos(radians(80)) * glm::length(seen)) {
            throw Error(subject, "the light must stand clear of the points: each less than 80 degrees off the middle",
                        vectorText(p));
        }
        box.add({seen.x / distance, seen.y / distance, distance});
    }
    return box;
}

// The perspective that holds the points, for a light that looks as viewFromWorld says.
LightView throughWindow(const mat4& viewFromWorld, std::span<const vec3> points, double margin, double extent) {
    LightView view{.viewFromWorld = viewFromWorld};
    Bounds box = windowAtOne(viewFromWorld, points);
    const double leastDepth = 1e-3 * extent, leastAngle = leastDepth / box.high.z;
    double near = box.low.z, far = box.high.z;
    widen(near, far, margin, leastDepth);
    near = std::max(near, box.low.z / 2);  // before the light, whatever the margin
    widen(box.low.x, box.high.x, margin, leastAngle);
    widen(box.low.y, box.high.y, margin, leastAngle);
    view.bounds = {near * box.low.x, near * box.high.x, near * box.low.y, near * box.high.y, near, far};
    view.clipFromView = frustum(view.bounds);
    return view;
}

LightView fromPoint(const vec3& light, std::span<const vec3> points, const Bounds& world, double margin,
                    double extent) {
    if (world.middle() == light) throw Error(subject, "the light must not be amid the points", vectorText(light));
    const mat4 viewFromWorld = lookAtAnyRoll(light, world.middle());
    // Look at the middle of the window rather than of the box, where near points weigh no more than far ones.
    const vec3 gaze = windowAtOne(viewFromWorld, points).middle() * vec3(1, 1, 0) + vec3(0, 0, -1);
    return throughWindow(lookAtAnyRoll(light, light + glm::transpose(mat3(viewFromWorld)) * gaze), points, margin,
                         extent);
}

LightView fromInfinity(const vec3& towardsLight, std::span<const vec3> points, const Bounds& world, double margin,
                       double extent) {
    LightView view;
    view.atInfinity = true;
    view.viewFromWorld = lookAtAnyRoll(world.middle() + extent * glm::normalize(towardsLight), world.middle());
    Bounds box;
    for (const vec3& p : points) box.add(vec3(view.viewFromWorld * vec4(p, 1)) * vec3(1, 1, -1));
    for (int axis = 0; axis < 3; ++axis) widen(box.low[axis], box.high[axis], margin, 1e-3 * extent);
    view.bounds = {box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z};
    view.clipFromView = ortho(box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z);
    return view;
}

std::vector<vec3> worldPoints(const Scene& scene, bool castersOnly) {
    std::vector<vec3> points;
    for (const SceneObject& object : scene.objects) {
        if (castersOnly && !object.casts) continue;
        for (const fvec3& p : object.mesh.positions) points.emplace_back(object.worldFromObject * vec4(vec3(p), 1));
    }
    return points;
}

}  // namespace

mat4 mapFromClip() { return translate(0.5, 0.5, 0.5) * scale(0.5); }

mat4 LightView::mapFromWorld() const { return mapFromClip() * clipFromWorld(); }

LightView fitLightView(const vec4& light, std::span<const vec3> points, double margin) {
    requireFinite(subject, "the light", light);
    requireMargin(margin);
    if (light.w < 0 || light == vec4(0)) {
        throw Error(subject, "the light must be a point (w > 0) or a direction (w = 0)", vectorText(light));
    }
    const Bounds world = boundsOfSeveral(points);
    const double extent = glm::length(world.high - world.low);
    if (light.w == 0) return fromInfinity(vec3(light), points, world, margin, extent);
    return fromPoint(vec3(light) / light.w, points, world, margin, extent);
}

LightView fitLightView(const vec3& light, const vec3& gaze, const vec3& up, std::span<const vec3> points,
                       double margin) {
    requireMargin(margin);
    const Bounds world = boundsOfSeveral(points);
    return throughWindow(lookAt(light, light + gaze, up), points, margin, glm::length(world.high - world.low));
}

std::vector<vec3> casterPoints(const Scene& scene) { return worldPoints(scene, true); }
std::vector<vec3> scenePoints(const Scene& scene) { return worldPoints(scene, false); }

}  // namespace mv
