// The lit surface, and on it the edges of its triangles. The geometry shader hands on values under names of its own.
#define point onPoint
#define facing onFacing
#define place onPlace
#define level onLevel
#include "displaced.glsl"
noperspective in vec3 fromEdges;

void main() {
    float nearest = min(fromEdges.x, min(fromEdges.y, fromEdges.z));
    vec3 color = mix(vec3(0.02, 0.05, 0.15), srgbFromLinear(litHere()), 0.35 + 0.65 * clamp(nearest - 0.2, 0.0, 1.0));
    show(color, 1.0, true);
}
