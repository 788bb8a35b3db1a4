// The tessellator makes lines of one v each, and no triangle.
layout(isolines, equal_spacing) in;
#include "bezier.glsl"
