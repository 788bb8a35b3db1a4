// A figure before columns and a house, for a camera that goes away from it.
#pragma once
#include "mv/geometry/scene.h"

namespace mv {

// Lengths are metres, y is up. The figure, 2 m high, stands at the origin; on both sides and behind it are columns of 4 m, at
// z = -8 to -38, and 20 m behind it a house whose door is 3 m high. There is neither light nor camera.
//
// The objects are in an order in which they may be painted over one another without a depth buffer, with back faces
// culled: for a camera at (0, 1, z), z 1 or more, that looks along -z.
Scene figureInStreet();
inline constexpr double figureHeight = 2, doorHeight = 3, doorBehindFigure = 20;

}  // namespace mv
