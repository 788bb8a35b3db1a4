// Lines of sight to reliefs, in double precision: the truth that bumped pictures are compared with.
#pragma once
#include <optional>

#include "shared/relief.h"

namespace mv {

// The point where a line of sight first meets the displaced surface, where it is 5e-5 units or less above it; nothing
// where it passes by. `from` is any point on the line before the smooth surface, `way`, of unit length, points away
// from the eye. The search marches by the surface's steepest slope, so that it steps over nothing; of the wall the line
// may meet all of the plane. Refused: a line that runs along the wall or away from it.
std::optional<ReliefPoint> firstHit(const Relief& relief, const vec3& from, const vec3& way);

}  // namespace mv
