// Deferred: each pixel asks all lamps, once.
#include "small_lamps.glsl"
#include "stored_surface.glsl"
uniform vec3 place[96], power[96];
uniform int count;
uniform float ambient;
out vec4 sum;

void main() {
    Surface surface = surfaceAt(ivec2(gl_FragCoord.xy));
    if (!surface.isThere) discard;
    vec3 light = vec3(ambient);
    for (int i = 0; i < count; ++i) light += lightOf(place[i], power[i], surface.point, surface.normal);
    sum = vec4(surface.color * light, 1.0);
}
