// The point of a line, a plane or a triangle that is nearest to a point. Their distance is glm::distance of the two.
//
// Differences from a corner are taken first, so that digits are lost to the sizes of things, not to how far from the origin they
// are. Coordinates 0 or from 1e-70 to 1e70 in size. All refuse NaN and infinity.
#pragma once
#include "mv/math/types.h"

namespace mv {

// On the line through a and b. Refused: a equal to b, which is no line.
vec3 closestOnLine(const vec3& point, const vec3& a, const vec3& b);

// On the segment from a to b, which may be a point. Its ends come back as they are.
vec3 closestOnSegment(const vec3& point, const vec3& a, const vec3& b);

// On the plane of the points with dot(plane.xyz, p) + plane.w = 0, whose normal may have any length but 0, which is refused.
vec3 closestOnPlane(const vec3& point, const vec4& plane);

// On the triangle: inside of it, on an edge or at a corner. One without area is its longest edge.
// The method uses areas that are signed products of differences; where these are known to no digit, as of a slender
// triangle, the nearest of the three edges' points, which is right there. Source: the regions of Ericson, "Real-Time
// Collision Detection" (2005), section 5.1.5.
vec3 closestOnTriangle(const vec3& point, const vec3& a, const vec3& b, const vec3& c);

}  // namespace mv
