// A light's rays through the corners of what casts, over a picture: light, corner and corner of the shadow on one line.
#pragma once
#include <span>
#include <vector>

#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"

namespace mv {

// The corners of a body, in world space: its distinct positions, where there are at most eight, as a box or a square has.
// Empty for a round body.
std::vector<vec3> cornersOf(const MeshData& mesh, const mat4& worldFromModel);

// Draws a dot at the light, and a line from it through each corner to the nearest plane behind the corner (dot(plane, p) = 0);
// to the corner itself where there is no such plane. The pane is the drawing's; nearer things hide the lines. The light is
// as in SceneLight; the rays of one at infinity begin 3 units before the corners.
void drawLightRays(Drawing& drawing, const mat4& clipFromWorld, const vec4& light, std::span<const vec3> corners,
                   std::span<const vec4> planes);

// The same for the first light of a scene, from the corners of what casts to what receives. Those objects are planes across
// the y axis of their own space, as floors and walls are.
void drawSceneRays(Drawing& drawing, const Scene& scene, const Frame& frame);

}  // namespace mv
