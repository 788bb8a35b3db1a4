// The tessellator, which no shader is for, makes triangles of the square.
layout(quads, equal_spacing, ccw) in;
#include "bezier.glsl"
