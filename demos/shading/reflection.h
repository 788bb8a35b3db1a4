// Reflection by the models of the lecture, in double precision: what shaders/include/reflection.glsl computes in float.
//
// All vectors have unit length and point away from the surface: n its normal, l to the light, v to the eye.
#pragma once
#include "mv/math/types.h"

namespace mv {

enum class Lobe { phong, blinn, brushed };

// The highlight, 0..1: cos^exponent of the angle between v and the mirrored l (Phong), between n and the half vector of l
// and v (Blinn), or between v and the nearest direction into which threads round the y axis reflect (brushed). 0 where l
// is behind the surface, and where there is no half vector (v = -l).
double highlight(Lobe lobe, const vec3& n, const vec3& l, const vec3& v, double exponent);

// The light sent towards v for light from l, as a part of what arrives: Lambert's is constant, a highlight is divided by
// n . l, as the lecture's definition f_r = L / (L_in cos) makes of it. Infinity where n . l is 0.
double reflectance(Lobe lobe, const vec3& n, const vec3& l, const vec3& v, double exponent);

// The exponent with which Blinn's highlight sends as much light, over all directions above the surface, as Phong's does
// with that exponent, for light at that angle from the normal, in degrees. Long highlights: near 4 exponent cos(angle).
// Computed by sums over 128 x 32 directions, to a hundredth of itself. Refused: exponent outside 1..1000, angle outside
// 0..80.
double matchingExponent(double exponent, double angle);

}  // namespace mv
