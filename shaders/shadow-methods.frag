#include "light.glsl"

uniform vec4 light;      // world space, homogeneous
uniform vec3 color;
uniform float lit;       // the part of the light that gets through: 0 in shadow
uniform bool measuring;  // write that part as a number, instead of a picture
in vec3 worldPoint;
in vec3 worldNormal;
out vec4 fragColor;

void main() {
    if (measuring) {
        fragColor = vec4(facesLight(worldPoint, light) ? lit : -1.0);
    } else {
        fragColor = vec4(shade(color, worldPoint, normalize(worldNormal), light, lit), 1.0);
    }
}
