// Lamps that have a size: the points that stand for them, and the penumbra that they throw.
#pragma once
#include <cstdint>
#include <vector>

#include "mv/geometry/scene.h"

namespace mv {

// side x side points of the lamp's parallelogram (world space), one in each of equal cells, at the place that
// jitteredSquare(side, seed) gives: the same in every picture. For a lamp without size all are its position.
// Refused: what jitteredSquare refuses, a light at infinity.
std::vector<vec3> lampPoints(const SceneLight& lamp, int side, std::uint32_t seed);

// The penumbra of a straight edge on the floor y = 0: where it falls and how wide it is.
struct Penumbra {
    vec3 middle{0, 0, 0};    // on the floor, the shadow of the edge's point by the middle of the lamp
    vec3 outwards{1, 0, 0};  // unit length, along the floor, from dark to lit
    double width = 0;        // from where none of the lamp is seen to where all of it is, along `outwards`
};

// For a level lamp, and an edge through the point `edge` that is level too, with the caster on one side and `outwards`
// (level, of unit length) pointing to the other; a long one: its ends throw penumbrae of their own. The width, by
// similar triangles, is the lamp's extent along `outwards`, seen through the edge: extent * y / (lamp's y - y). Along a
// side of the parallelogram the extent is that side's length. Refused: an edge below the floor or not below the lamp, a
// light at infinity, a lamp or a direction that is not level.
Penumbra penumbraOf(const SceneLight& lamp, const vec3& edge, const vec3& outwards);

}  // namespace mv
