// The Utah teapot.
#pragma once
#include <vector>

#include "mv/geometry/bezier_patch.h"

namespace mv {

// The 32 patches: rim 4, body 8, lid 8, bottom 4, handle 4, spout 4. The pot stands on the plane y = 0 with its middle
// on the y axis, 3.15 high, from the end of its handle at x = -3 to its spout at x = 3.5; fronts are outside. The tip
// of the lid and the middle of the bottom are edges that have collapsed to a point. The traps: it is not closed, since
// the lid hangs above the rim and handle and spout stick into the body; its round parts are no exact circles (see the
// source). Source: Newell, 1975; Blinn's proportions, and the bottom that Newell's had not, as in Crow, "The Origins of
// the Teapot", IEEE Computer Graphics and Applications 7 (1987).
std::vector<BezierPatch> teapot();

}  // namespace mv
