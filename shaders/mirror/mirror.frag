#include "light.glsl"
#include "seen.glsl"

uniform vec4 light;
uniform vec3 color;
uniform float number;  // of the object
uniform float part;    // of its light that the mirrors in between leave
in vec3 worldPoint;
in vec3 worldNormal;

void main() {
    vec3 own = color;
    // The floor's tiles, 2 by 2
    if (number == 1.0 && mod(floor(0.5 * worldPoint.x) + floor(0.5 * worldPoint.z), 2.0) == 1.0) own *= 0.6;
    showSeen(part * shade(own, worldPoint, normalize(worldNormal), light, 1.0), number);
}
