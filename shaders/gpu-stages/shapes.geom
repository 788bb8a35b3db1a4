// Geometry shader: of a point it makes a hexagon, as a strip of four triangles, that lies on the surface.
layout(points) in;
layout(triangle_strip, max_vertices = 6) out;
#include "primitive.glsl"
uniform float amount;

void main() {
    vec3 n = normalize(from[0].facing);
    vec3 across = normalize(cross(n, abs(n.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 along = cross(n, across);
    for (int i = 0; i < 6; ++i) {
        // 0, 1, 5, 2, 4, 3: from side to side
        int corner = i % 2 == 1 ? (i + 1) / 2 : (6 - i / 2) % 6;
        float angle = 1.0471976 * float(corner);
        emit(from[0].place + 0.4 * amount * (cos(angle) * across + sin(angle) * along), n);
    }
}
