// Cutting polygons to half spaces before the division by w, where a cut is still a cut.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// The part of a convex polygon that lies in every half space h, dot(h, p) >= 0: its corners in the same order, empty
// where nothing is left. Points are homogeneous (x, y, z, w) and may have any w, 0 and below too: cutting needs no
// division, so clip space is where to cut (after the division a point behind the eye shows up in front, mirrored).
// Two points are a segment. A corner exactly on a bound stays. The same half space cuts an edge that two polygons share
// at the same bits in both. The new corner lies on the bound but for some roundings where numbers are 0 or from 1e-100
// to 1e100 in size. Refused: NaN and infinity. Source: Sutherland and Hodgman, "Reentrant polygon clipping" (1974), in
// homogeneous coordinates as in Blinn and Newell, "Clipping using homogeneous coordinates" (1978).
std::vector<vec4> clipPolygon(std::vector<vec4> polygon, std::span<const vec4> halfSpaces);

// The six half spaces of OpenGL's clip space, -w <= x, y, z <= w: w + x, w - x, w + y, w - y, w + z, w - z.
const std::array<vec4, 6>& clipVolume();

// The area of a flat polygon of at least three corners in order, of any size; 0 for fewer. Refused: NaN and infinity, and an
// area that overflows.
double polygonArea(std::span<const vec3> corners);

}  // namespace mv
