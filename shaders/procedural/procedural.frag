// The pattern of a point, of several points of a pixel, or without what a pixel cannot show.
#include "measure.glsl"
#include "procedural.glsl"
#include "srgb.glsl"
uniform vec3 dark, light;    // colours of 0 and 1, linear
uniform int samples;         // a side of a pixel
uniform bool leavesOut;      // what is smaller than a pixel
uniform bool fromFar;        // the point is rounded to floats, and its cell found from that
uniform vec3 far;            // the centre
uniform bool isRound;         // shaded, from the left and above; of which a study asks what is turned to the eye by 60 degrees
uniform bool isFloor;         // of which it asks up to 20 units away
in vec3 offset;
in vec3 facing;

void main() {
    vec3 across = dFdx(offset), up = dFdy(offset);
    vec3 size = leavesOut ? abs(across) + abs(up) : vec3(0.0);
    float sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        for (int j = 0; j < samples; ++j) {
            vec2 part = (vec2(float(i), float(j)) + 0.5) / float(samples) - 0.5;
            vec3 at = offset + part.x * across + part.y * up;
            if (fromFar) at = far + at;
            sum += patternAt(at, size);
        }
    }
    float mean = sum / float(samples * samples);
    vec3 color = mix(dark, light, mean);
    if (isRound) color *= 0.25 + 0.75 * max(dot(normalize(facing), vec3(-0.48, 0.6, 0.64)), 0.0);
    show(srgbFromLinear(color), mean, isFloor ? offset.y < 20.0 : !isRound || normalize(facing).z > 0.5);
}
