#include "light.glsl"

uniform vec4 light;      // world space, homogeneous
uniform vec3 color;
uniform float lit;       // the part of the light that gets through: 0 in shadow
uniform bool measuring;  // write that part as a number, instead of a picture
in vec3 worldPoint;
in vec3 worldNormal;
out vec4 fragColor;

// Whether the triangle's front faces the light: its own normal, not the smooth one of the shading.
bool facesLight() {
    vec3 normal = cross(dFdx(worldPoint), dFdy(worldPoint));  // towards the eye
    return (dot(normal, towardsLight(worldPoint, light)) > 0.0) == gl_FrontFacing;
}

void main() {
    if (measuring) {
        fragColor = vec4(facesLight() ? lit : -1.0);
    } else {
        fragColor = vec4(shade(color, worldPoint, normalize(worldNormal), light, lit), 1.0);
    }
}
