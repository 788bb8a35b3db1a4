// Normal mapping: the normal is looked up.
#include "bumped.glsl"
uniform sampler2D normals;

void main() {
    vec3 normal = 2.0 * texture(normals, place).xyz - 1.0;
    showLit(texture(painted, place).rgb, bodyFromFrame() * normalize(normal));
}
