// Whether a ball or a box is in a view volume: what is whole outside need not be drawn.
#pragma once
#include <span>

#include "mv/math/types.h"

namespace mv {

// outside: whole on the outer side of one plane. inside: whole on the inner side of all. crossing: neither.
enum class InVolume { outside, crossing, inside };

// The planes (n, d) have their normals inwards, as those of planesFromClip and perspectivePlanes, and are those of the space of
// the points: plane * matrix takes one back from where the matrix leads. A plane whose normal is 0 leaves nothing out.
// Both answers are certain but for roundings of the coordinates, and what the planes' normals are off by, in their unit.
// Trap: near an edge of the volume what lies outside of two planes, each crossed, is called crossing; it is drawn for nothing.
// Refused: NaN and infinity.

// Judges a convex body by its corners: a box by the eight, which may be turned. Planes may have normals of any length.
// Without corners: outside.
InVolume hullInVolume(std::span<const vec3> corners, std::span<const vec4> planes);

// Judges a ball; the planes' normals have unit length. Cheaper than a box by six times, and larger than most things.
// Refused: a radius below 0.
InVolume ballInVolume(const vec3& center, double radius, std::span<const vec4> planes);

}  // namespace mv
