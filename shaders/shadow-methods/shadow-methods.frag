#include "light.glsl"
#include "measure.glsl"

uniform vec4 light;  // world space, homogeneous
uniform vec3 color;
uniform float lit;   // the part of the light that gets through: 0 in shadow
in vec3 worldPoint;
in vec3 worldNormal;

void main() {
    show(shade(color, worldPoint, normalize(worldNormal), light, lit), lit, facesLight(worldPoint, light));
}
