// One lookup: which texels are read for it, and how they are mixed, is the texture's filter.
#include "measure.glsl"
#include "srgb.glsl"
uniform sampler2D image;
uniform float bias;    // added to the level
uniform bool encoded;  // the texture gives what is kept instead of linear light
in vec2 place;

void main() {
    vec3 texel = texture(image, place, bias).rgb;
    vec3 light = encoded ? linearFromSrgb(texel) : texel;
    show(encoded ? texel : srgbFromLinear(texel), dot(light, vec3(0.2126, 0.7152, 0.0722)),
         length(place) > 2.0 && length(place) < 100.0);
}
