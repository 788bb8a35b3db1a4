#include "measure.glsl"
uniform vec3 color;

void main() { show(color, 0.0, true); }
