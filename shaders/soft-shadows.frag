// The picture: each pixel shaded by the part of the lamp that reaches it.
#include "light.glsl"
uniform sampler2D darkness;  // of each pixel of this picture: 0 sees the whole lamp, 1 none of it
uniform vec3 lamp;           // its middle
uniform vec3 color;
uniform bool measuring;
in vec3 point;
in vec3 facing;
out vec4 fragColor;

void main() {
    float lit = 1.0 - texelFetch(darkness, ivec2(gl_FragCoord.xy), 0).r;
    // A study compares the surfaces that look towards the lamp.
    bool counts = dot(cross(dFdx(point), dFdy(point)), lamp - point) > 0.0;
    fragColor = measuring ? vec4(counts ? lit : -1.0)
                          : vec4(shade(color, point, normalize(facing), vec4(lamp, 1.0), lit), 1.0);
}
