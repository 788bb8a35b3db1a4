// The pattern of a point, of several points of a pixel, or without what a pixel cannot show.
#include "procedural.glsl"
#include "procedural-look.glsl"
uniform int samples;         // a side of a pixel
uniform bool leavesOut;      // what is smaller than a pixel
uniform bool fromFar;        // the point is rounded to floats, and its cell found from that
uniform vec3 far;            // the centre
uniform bool isFloor;        // of which a study asks up to 20 units away
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
    showPattern(sum / float(samples * samples), facing, !isFloor || offset.y < 20.0);
}
