// A light's camera: the view and projection with which a shadow map is drawn and looked up.
#pragma once
#include <span>
#include <vector>

#include "mv/geometry/scene.h"
#include "mv/math/projection.h"

namespace mv {

// A light's own camera. Its space looks along -z from the light.
struct LightView {
    mat4 viewFromWorld{1};
    mat4 clipFromView{1};
    // The arguments of frustum(), or for a light at infinity of ortho(): in world units, which distances from depths need.
    FrustumBounds bounds{};
    bool atInfinity = false;

    mat4 clipFromWorld() const { return clipFromView * viewFromWorld; }
    // Takes points to the map's own coordinates: after division by w, x and y are texture coordinates 0..1 and z the
    // depth 0..1.
    mat4 mapFromWorld() const;
};

// mapFromClip: halves and shifts -1..1 to 0..1, in x, y and z. mapFromClip() * clipFromWorld is mapFromWorld.
mat4 mapFromClip();

// The tightest view from the light that holds all the points (world space): an off-axis perspective from a point, a
// parallel projection along a direction; the points fill the window, and near to far, but for `margin` of its width (of
// the range of depths) on each side. A shadow falls only where a caster is seen from the light, so a map needs to hold
// what casts, not the floor under it: what a map does not hold is lit. The roll is lookAtAnyRoll's.
// `light` is homogeneous: (x, y, z, w > 0) the point (x, y, z)/w, (x, y, z, 0) the direction towards a light at
// infinity. A direction in which the points have no extent counts as a thousandth of their largest one.
// Refused: no points, or all of them one; a light that is 0, or that the points surround, so that one is 80 degrees or
// more off the middle; a margin outside 0..0.4; NaN, infinity.
LightView fitLightView(const vec4& light, std::span<const vec3> points, double margin = 0.02);

// The same from a point light with its gaze and up (world space, as directions) given instead of chosen: the window then
// leans as far to the side as the points ask. For a lamp, gaze along its normal: depths are then distances from its
// plane, and the lamp, seen through a point, looks the same everywhere on a plane of one depth. Refused besides: a point
// 80 degrees or more off the gaze, gaze and up on one line.
LightView fitLightView(const vec3& light, const vec3& gaze, const vec3& up, std::span<const vec3> points,
                       double margin = 0.02);

// The vertices in world space, of the objects that cast, or of all.
std::vector<vec3> casterPoints(const Scene& scene);
std::vector<vec3> scenePoints(const Scene& scene);

}  // namespace mv
