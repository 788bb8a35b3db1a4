// From a point of a triangle's plane to its texture coordinates, in two ways.
#pragma once
#include <array>

#include "mv/math/types.h"

namespace mv {

struct TexturedTriangle {
    std::array<vec3, 3> points;
    std::array<vec2, 3> texture;
};

// (u, v) = linear (p - corner) + atCorner. The third row of linear is not used.
struct PlaneMap {
    mat3 linear{0};
    vec3 corner{0};
    vec2 atCorner{0};
    vec2 at(const vec3& point) const { return vec2(linear * (point - corner)) + atCorner; }
};

// The lecture's P, with (x, y, z) = P (u, v, 1). Refused: texture coordinates on a line.
mat3 pointFromTexture(const TexturedTriangle& triangle);
// Map by the inverse of P, from the point itself. Refused: a plane that contains the origin, for which P has no inverse.
PlaneMap mapByMatrix(const TexturedTriangle& triangle);
// Made from the changes of u and v along the plane from the first corner on: nothing here asks where the origin is, and
// any texture coordinates do. Refused: a triangle without area.
PlaneMap mapByEdges(const TexturedTriangle& triangle);

// How far the map, its numbers and products rounded to float, misses the texture coordinates of a corner, at most.
double errorInFloats(const PlaneMap& map, const TexturedTriangle& triangle);

}  // namespace mv
