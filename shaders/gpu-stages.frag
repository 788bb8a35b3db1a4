// Fragment shader: once for each pixel that a triangle covers. Both sides are lit alike.
#include "vertex.glsl"
uniform vec3 color;
VERTEX(in);
out vec4 fragColor;

void main() {
    float cosine = abs(dot(normalize(facing), normalize(vec3(0.3, 0.9, 0.4))));
    fragColor = vec4(color * (0.45 + 0.55 * cosine), 1.0);
}
