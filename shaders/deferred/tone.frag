// From the sum of all light, which has no upper end, to a picture, which ends at 1. A study measures the sum.
#include "measure.glsl"
#include "srgb.glsl"
uniform sampler2D sums;
uniform bool reinhard;
uniform vec3 background;

void main() {
    vec4 sum = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
    float luminance = dot(sum.rgb, vec3(0.2126, 0.7152, 0.0722));
    vec3 shown = reinhard ? sum.rgb / (1.0 + luminance) : sum.rgb;
    show(sum.a > 0.5 ? srgbFromLinear(min(shown, 1.0)) : background, (sum.r + sum.g + sum.b) / 3.0, sum.a > 0.5);
}
