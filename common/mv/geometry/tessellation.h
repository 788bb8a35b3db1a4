// Levels of tessellation: into how many pieces the edges and the inside of a patch are cut. shaders/include/tessellation.glsl
// has the same rule for shaders.
#pragma once
#include <array>

#include "mv/math/types.h"

namespace mv {

// Every driver takes levels up to this one (GL_MAX_TESS_GEN_LEVEL is at least that).
inline constexpr double largestLevel = 64;

// The level that is drawn where `wanted` is asked for: in 1 .. 64. A level that is not above 1 is 1, NaN too: OpenGL
// leaves out a whole patch one of whose outer levels is 0, and a hole is never what a level was meant to say.
double levelInRange(double wanted);

// The outer level of an edge from a to b as the eye sees it: `fineness` pieces where it is as long as it is far away.
// The level is the same from b to a, bit for bit, and reads nothing but the edge: patches that share it cut it alike.
// 64 where the eye is in the edge's middle; 1 where the edge has no length.
double edgeLevel(const vec3& a, const vec3& b, const vec3& eye, double fineness);

// The triangles that OpenGL's tessellator makes of a square patch with `equal_spacing`, whose four outer levels are `outer`,
// and whose two inner ones are `inner`: each is rounded up to a whole number, and an inner 1 beside a larger outer one is 2.
// Refused: levels outside 1 .. 64, NaN.
long trianglesOfSquare(double inner, double outer);
// The same of four outer levels of their own.
long trianglesOfSquare(double inner, const std::array<double, 4>& outer);

}  // namespace mv
