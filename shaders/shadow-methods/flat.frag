#include "light.glsl"
#include "measure.glsl"

uniform vec3 color;

void main() { show(ambientShare * color, 0.0, true); }  // what is left in shadow
