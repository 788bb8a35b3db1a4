#include "light.glsl"

uniform vec3 color;
out vec4 fragColor;

void main() { fragColor = vec4(ambientShare * color, 1.0); }  // what is left in shadow
