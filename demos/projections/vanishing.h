// Vanishing points, and lines that run to infinity.
//
// A point at infinity is a direction (x, y, z, 0). In the meshes below texCoord.x says which a position is, 1 for a
// direction and 0 for a point, so that a vertex shader takes both through one matrix:
//     gl_Position = clipFromWorld * vec4(position, 1.0 - texCoord.x);
// A perspective draws them to their end with infinitePerspective(), for which no direction is too far.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "mv/geometry/mesh_data.h"

namespace mv {

// From each point a line to infinity along x, then from each along y, then along z: 2 vertices a line, 2 points.size()
// an axis; positions and texCoords. Refused: NaN, and what float takes for infinity.
MeshData linesToInfinity(std::span<const vec3> points);

// All directions with y = 0, in 64 lines: seen through a perspective, the horizon of a world with y upwards.
MeshData horizonLines();

// The point where all lines along `direction` meet in a picture of width x height pixels: the image of the point at
// infinity, x to the right and y up from its lower left corner; it may lie outside of the picture, and the lines may
// run towards it or away from it. Empty where they are parallel to the picture, up to 1e-12 rad, and so in every
// parallel projection. Refused: a direction that is 0, NaN, infinity, a size below 1.
std::optional<vec2> vanishingPoint(const mat4& clipFromWorld, const vec3& direction, int width, int height);

// The distance by which the image of the edge from a to b misses that point when it is drawn longer: how far b's image
// is from the line through a's image and the point, in pixels. a and b are taken through the matrix in float, as the
// GPU does, so that this is the error of the picture. Refused: an end at or behind the eye, NaN, infinity, a size below
// 1.
double missOfVanishingPoint(const vec2& point, const std::array<vec3, 2>& edge, const mat4& clipFromWorld, int width,
                            int height);

}  // namespace mv
