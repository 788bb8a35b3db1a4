// Fragment shader: the edges in their colour, and the face in that of paper. Faces hide what is behind them, so hidden lines
// are gone.
#include "vertex.glsl"
uniform vec3 color;
VERTEX(in);
noperspective in vec3 fromEdges;
out vec4 fragColor;

void main() {
    float nearest = min(fromEdges.x, min(fromEdges.y, fromEdges.z));
    vec3 paper = vec3(1.0) - 0.12 * abs(normalize(facing).zyx);
    fragColor = vec4(mix(color, paper, clamp(nearest - 0.3, 0.0, 1.0)), 1.0);
}
