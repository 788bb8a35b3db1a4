// Forward: each fragment asks all lamps, also one that another fragment hides later.
#include "small_lamps.glsl"
uniform vec3 place[96], power[96];
uniform int count;
uniform float ambient;
in vec3 worldPoint;
in vec3 worldNormal;
in vec3 ownColor;
out vec4 sum;

void main() {
    vec3 light = vec3(ambient), normal = normalize(worldNormal);
    for (int i = 0; i < count; ++i) light += lightOf(place[i], power[i], worldPoint, normal);
    sum = vec4(ownColor * light, 1.0);
}
