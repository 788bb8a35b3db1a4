// Flat shading: the light of the face's last vertex.
#include "reflection.glsl"
#include "measure.glsl"
flat in vec4 light;
in vec3 point;

void main() { show(light.rgb + light.w, light.w, isMiddle(point)); }
