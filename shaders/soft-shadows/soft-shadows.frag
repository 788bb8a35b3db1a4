// The picture: each pixel shaded by the part of the lamp that reaches it.
#include "light.glsl"
#include "measure.glsl"
uniform sampler2D darkness;  // of each pixel of this picture: 0 sees the whole lamp, 1 none of it
uniform vec3 lamp;           // its middle
uniform vec3 color;
in vec3 point;
in vec3 facing;

void main() {
    float lit = 1.0 - texelFetch(darkness, ivec2(gl_FragCoord.xy), 0).r;
    show(shade(color, point, normalize(facing), vec4(lamp, 1.0), lit), lit, facesLight(point, vec4(lamp, 1.0)));
}
