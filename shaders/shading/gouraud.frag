// Gouraud shading: the vertices' light, interpolated over the face.
#include "reflection.glsl"
#include "measure.glsl"
in vec4 light;
in vec3 point;

void main() { show(light.rgb + light.w, light.w, isMiddle(point)); }
