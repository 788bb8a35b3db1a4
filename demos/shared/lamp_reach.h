// Whether a lamp that ends at a distance can light anything that is seen: what it cannot, no shader need ask.
#pragma once
#include "mv/geometry/scene.h"

namespace mv {

// Whether the ball of radius `reach` about the lamp touches the view volume of clipFromWorld (finite), and the bounds of an
// object of the scene. True where in doubt: bounds hold more than their object, and a ball may touch the sides of a corner
// and not the volume.
bool canReach(const Scene& scene, const mat4& clipFromWorld, const vec3& lamp, double reach);

}  // namespace mv
