// The tessellator makes triangles of a triangle: the half of the sheet where u + v <= 1.
layout(triangles, equal_spacing, ccw) in;
#include "bezier.glsl"
