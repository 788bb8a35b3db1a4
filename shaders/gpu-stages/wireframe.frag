// Fragment shader: the edges in their colour, and the face in that of paper. Faces hide what is behind them, and so hidden
// lines, too. These are drawn once more where they are behind, paler and without their faces.
#include "measure.glsl"
#include "vertex.glsl"
uniform vec3 color;
uniform bool isHidden;
VERTEX(in);
noperspective in vec3 fromEdges;

void main() {
    float nearest = min(fromEdges.x, min(fromEdges.y, fromEdges.z));
    float face = clamp(nearest - 0.3, 0.0, 1.0);
    if (isHidden && face == 1.0) discard;
    vec3 paper = vec3(1.0) - 0.12 * abs(normalize(facing).zyx);
    show(mix(isHidden ? mix(color, paper, 0.5) : color, paper, face), 1.0 / gl_FragCoord.w, true);
}
