#include "light.glsl"

uniform vec4 light;  // world space, homogeneous
uniform vec3 color;
in vec3 worldPoint;
in vec3 worldNormal;
out vec4 fragColor;

void main() { fragColor = vec4(shade(color, worldPoint, normalize(worldNormal), light, 1.0), 1.0); }
