#include "light.glsl"
#include "measure.glsl"

uniform vec4 light;  // world space, homogeneous
uniform float lit;   // 1 for whole polygons, 0 for their dark parts
in vec3 worldPoint;
in vec3 worldNormal;
in vec3 surface;

// Fronts are the sides towards the light; the other sides are dark without any shadow.
void main() {
    float reached = gl_FrontFacing ? lit : 0.0;
    show(shade(surface, worldPoint, normalize(worldNormal), light, reached), reached, gl_FrontFacing);
}
