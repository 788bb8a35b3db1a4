// Geometry shader: it moves a triangle out along the normal of its face, and shrinks it about its middle. No vertex shader
// can: it knows neither.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
#include "primitive.glsl"
uniform float amount;

void main() {
    vec3 middle = (from[0].place + from[1].place + from[2].place) / 3.0;
    vec3 n = normalize(cross(from[1].place - from[0].place, from[2].place - from[0].place));
    n *= sign(dot(n, from[0].facing));
    for (int i = 0; i < 3; ++i) emit(mix(from[i].place, middle, 0.8 * amount) + amount * n, from[i].facing);
}
