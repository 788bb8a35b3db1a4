// Fragment shader: once for each pixel that a triangle covers. Both sides are lit alike. A study measures how deep in the
// picture it is.
#include "measure.glsl"
#include "vertex.glsl"
uniform vec3 color;
VERTEX(in);

void main() {
    float cosine = abs(dot(normalize(facing), normalize(vec3(0.3, 0.9, 0.4))));
    show(color * (0.45 + 0.55 * cosine), 1.0 / gl_FragCoord.w, true);
}
