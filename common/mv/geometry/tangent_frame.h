// The needs of a surface's texture besides its points: a frame along it, a normal between corners, and coordinates that
// floats still tell apart.
#pragma once
#include <array>

#include "mv/math/types.h"

namespace mv {

// Three unit vectors, each across the other two: along the surface, along it again, and out of it. A normal map's colours
// are its coordinates.
struct TangentFrame {
    vec3 tangent, bitangent, normal;
    double sign;  // 1, or -1 where the texture is mirrored: bitangent = sign cross(normal, tangent)
};

// The frame of a triangle, counter-clockwise seen from outside. The tangent is the direction in which u grows and v
// stays; where the texture coordinates lie on a line and have no such direction, that in which u grows fastest along
// the surface with v's part left out, and where they are all equal any direction: that of the longest edge. Trap: the
// usual form divides by the area in the texture, which is then 0. Refused: a triangle without area, and what is not
// finite.
TangentFrame tangentFrame(const std::array<vec3, 3>& points, const std::array<vec2, 3>& texCoords);

// The corners' normals by these weights, as a unit vector; `face`, the flat normal, where they cancel each other to within
// the roundings of doubles. The face's is a unit vector.
vec3 shadingNormal(const std::array<vec3, 3>& normals, const vec3& weights, const vec3& face);

// A texture coordinate for a texture that repeats, 0 up to 1: its whole part is dropped before it is rounded to float, which
// at 1e7 has none of the rest left. Refused: not finite.
float repeatedCoordinate(double coordinate);

}  // namespace mv
