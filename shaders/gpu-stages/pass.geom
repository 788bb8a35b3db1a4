// Geometry shader: it gives each triangle as it was given it. A stage needs no more to be there.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
#include "primitive.glsl"

void main() {
    for (int i = 0; i < 3; ++i) emit(from[i].place, from[i].facing);
}
