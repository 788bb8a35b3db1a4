// The colour that a ray gives the same point, or for a study the object's number.
#include "measure.glsl"
uniform vec3 color, toLight;
uniform float id;
in vec3 facing;

void main() {
    show(color * (0.35 + 0.65 * abs(dot(normalize(facing), toLight))), id, true);
}
