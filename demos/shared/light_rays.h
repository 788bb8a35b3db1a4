// A light's rays through the corners of what casts, over a picture: light, corner and corner of the shadow on one line.
#pragma once
#include <span>
#include <vector>

#include "mv/geometry/scene.h"
#include "mv/gl/drawing.h"

namespace mv {

// The corners of a body, in world space: its different positions where these are at most eight, as of a box or a square; none of
// what is round.
std::vector<vec3> cornersOf(const MeshData& mesh, const mat4& worldFromModel);

// Draws, in the drawing's pane, a dot at the light and a line from it through each corner to the nearest plane behind that, dot(plane,
// p) = 0; where there is none, to the corner. They are hidden by what is nearer. The light as in SceneLight; of one at infinity the
// rays begin 3 before the corners.
void drawLightRays(Drawing& drawing, const mat4& clipFromWorld, const vec4& light, std::span<const vec3> corners,
                   std::span<const vec4> planes);

// The rays of a scene's first light through the corners of what casts, to what receives: planes across the y axis of their own
// space, as floors and walls are.
void drawSceneRays(Drawing& drawing, const Scene& scene, const Frame& frame);

}  // namespace mv
