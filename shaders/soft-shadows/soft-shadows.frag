// The picture: each pixel shaded by the part of the lamp that reaches it.
#include "light.glsl"
#include "measure.glsl"
uniform sampler2D darkness;  // of each pixel of this picture: 0 sees the whole lamp, 1 none of it
uniform int side;            // 1: its own darkness; else the mean of side x side pixels round it, a blur in the picture
uniform vec3 lamp;           // its middle
uniform vec3 color;
in vec3 point;
in vec3 facing;

float darknessHere() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(darkness, 0) - 1;
    float sum = 0.0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            ivec2 at = clamp(here + ivec2(i, j) - side / 2, ivec2(0), last);
            sum += texelFetch(darkness, at, 0).r;
        }
    }
    return sum / float(side * side);
}

void main() {
    float lit = 1.0 - darknessHere();
    show(shade(color, point, normalize(facing), vec4(lamp, 1.0), lit), lit, facesLight(point, vec4(lamp, 1.0)));
}
