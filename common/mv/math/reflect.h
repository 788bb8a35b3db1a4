// The directions of light at a smooth surface: mirrored, and refracted.
//
// `way` is the direction in which light travels, `normal` points to where it comes from; both have unit length, and so has
// what is returned, to some roundings. Who traces rays calls these for each of them: what is not finite gives what is not.
#pragma once
#include <optional>

#include "mv/math/types.h"

namespace mv {

// The direction after the mirror: way - 2 (way . normal) normal. Its side of the normal does not matter.
// Equals glm::reflect and GLSL's reflect(). Trap: for a normal that is not of unit length it is another vector's image.
vec3 reflected(const vec3& way, const vec3& normal);

// The direction behind a surface of glass, water, air: none where the light is totally reflected. `index` is that of what lies
// behind the surface over that of what lies before it; below 1 there is total reflection, from sin(angle) = index on.
// Computed by (index - 1)(index + 1) + cos^2, which loses nothing at that angle, nor where the index is nearly 1.
// Traps: GLSL's refract() and glm::refract want the reciprocal index, and return the zero vector where there is no light behind.
// Refused: an index that is not above 0 and at most 1e150. Source: Snell's law.
std::optional<vec3> refracted(const vec3& way, const vec3& normal, double index);

}  // namespace mv
