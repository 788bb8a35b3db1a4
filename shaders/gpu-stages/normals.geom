// Geometry shader: of a triangle it makes a line, its normal.
layout(triangles) in;
layout(line_strip, max_vertices = 2) out;
#include "primitive.glsl"
uniform float amount;

void main() {
    vec3 middle = (from[0].place + from[1].place + from[2].place) / 3.0;
    vec3 n = normalize(from[0].facing) + normalize(from[1].facing) + normalize(from[2].facing);
    emit(middle, n);
    emit(middle + amount * normalize(n), n);
}
