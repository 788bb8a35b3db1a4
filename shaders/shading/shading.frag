// Phong shading: each pixel asks what light its own normal reflects.
#include "reflection.glsl"
#include "measure.glsl"
in vec3 point;
in vec3 facing;

void main() {
    vec4 light = reflected(point, facing);
    show(light.rgb + light.w, light.w, isMiddle(point));
}
