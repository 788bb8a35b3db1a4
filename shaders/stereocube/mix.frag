#include "measure.glsl"
#include "srgb.glsl"

uniform sampler2D leftEye, rightEye;
uniform mat3 fromLeft, fromRight;  // of light, not of sRGB
uniform mat3 seenThrough;          // a glass; without one the identity
uniform vec3 brightness;           // of red, green and blue through it

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 left = linearFromSrgb(texelFetch(leftEye, at, 0).rgb), right = linearFromSrgb(texelFetch(rightEye, at, 0).rgb);
    vec3 mixed = clamp(fromLeft * left + fromRight * right, 0.0, 1.0);
    show(srgbFromLinear(clamp(seenThrough * mixed, 0.0, 1.0)), dot(brightness, mixed), true);
}
