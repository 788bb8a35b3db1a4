// A mirror shows the texture that was drawn as it is seen through it, so each pixel finds its texel at its own place.
#include "measure.glsl"
uniform sampler2D mirrored;
uniform vec3 lookup;  // the size of a pixel, as a part of the picture; and the part of the light that the mirror sends on

void main() {
    vec3 seen = texture(mirrored, gl_FragCoord.xy * lookup.xy).rgb;
    show(lookup.z * seen, floor(seen.r) + lookup.z * fract(seen.r), true);  // where it measures, red is a quantity
}
