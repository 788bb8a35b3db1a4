// Geometry shader: it tells each corner how far it is from the edge opposite it, in pixels. Interpolated over the triangle
// these are the distances from its edges, and the fragment shader draws those without a line being drawn.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
#include "primitive.glsl"
uniform vec2 halfPicture;
noperspective out vec3 fromEdges;

void main() {
    vec2 at[3];
    for (int i = 0; i < 3; ++i) {
        vec4 clip = clipFromWorld * vec4(from[i].place, 1.0);
        at[i] = halfPicture * clip.xy / clip.w;
    }
    vec2 a = at[1] - at[0], b = at[2] - at[0];
    float area = abs(a.x * b.y - a.y * b.x);
    for (int i = 0; i < 3; ++i) {
        fromEdges = vec3(0.0);
        fromEdges[i] = area / max(distance(at[(i + 1) % 3], at[(i + 2) % 3]), 1e-6);
        emit(from[i].place, from[i].facing);
    }
}
