// The tessellator makes points of a triangle.
layout(triangles, equal_spacing, point_mode) in;
#include "bezier.glsl"
