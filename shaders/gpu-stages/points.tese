// The tessellator, which no shader is for, makes points of the square.
layout(quads, equal_spacing, point_mode) in;
#include "bezier.glsl"
