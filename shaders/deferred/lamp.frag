// Lamp by lamp: only the pixels that its ball covers ask this one. Blending adds it to the sum.
#include "small_lamps.glsl"
#include "stored_surface.glsl"
uniform vec3 place, power;
out vec4 sum;

void main() {
    Surface surface = surfaceAt(ivec2(gl_FragCoord.xy));
    if (!surface.isThere) discard;
    sum = vec4(surface.color * lightOf(place, power, surface.point, surface.normal), 0.0);
}
