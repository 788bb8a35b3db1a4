// The look of a pattern's number 0..1: two colours and all between them, and on a round body the light from the left and above.
#include "measure.glsl"
#include "srgb.glsl"
uniform vec3 dark, light;  // colours of 0 and 1, linear
uniform bool isRound;      // shaded; a study asks for what is turned to the eye by 60 degrees at most

void showPattern(float value, vec3 facing, bool counts) {
    vec3 color = mix(dark, light, value);
    if (isRound) color *= 0.25 + 0.75 * max(dot(normalize(facing), vec3(-0.48, 0.6, 0.64)), 0.0);
    show(srgbFromLinear(color), value, counts && (!isRound || normalize(facing).z > 0.5));
}
