// As texture-filter.frag, with several looks along the footprint, which is bounded.
#include "footprint.glsl"
#include "measure.glsl"
#include "srgb.glsl"
uniform sampler2D image;
uniform int looks;     // along the footprint, at most
uniform float bias;    // added to the level
uniform bool encoded;  // the texture gives what is kept instead of linear light
in vec2 place;

void main() {
    vec3 texel = lookedUpAlong(image, place, looks, bias).rgb;
    vec3 light = encoded ? linearFromSrgb(texel) : texel;
    show(encoded ? texel : srgbFromLinear(texel), dot(light, vec3(0.2126, 0.7152, 0.0722)),
         length(place) > 2.0 && length(place) < 100.0);
}
