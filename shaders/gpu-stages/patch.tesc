// Tessellation control shader: once for each control point it gives, all of a patch knowing each other. The shader says
// how finely the patch is cut.
#include "tessellation.glsl"
layout(vertices = 16) out;
uniform float inner, outer;
in Vertex {
    vec3 place, facing;
}
from[];
out Vertex {
    vec3 place, facing;
}
to[];

void main() {
    to[gl_InvocationID].place = from[gl_InvocationID].place;
    to[gl_InvocationID].facing = from[gl_InvocationID].facing;
    if (gl_InvocationID > 0) return;
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = levelInRange(outer);
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = levelInRange(inner);
}
