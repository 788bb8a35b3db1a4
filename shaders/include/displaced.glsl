// How a displaced surface is lit: as one that was bumped, only that normals and points belong together.
#include "relief.glsl"
uniform bool showsLevels;
uniform vec3 levelColors[7];  // of the levels 1, 2, 4, ... 64, linear
in float level;

vec3 litHere() {
    vec3 color = texture(painted, place).rgb;
    if (showsLevels) {
        float step = clamp(log2(max(level, 1.0)), 0.0, 6.0);
        int below = min(int(step), 5);
        color = mix(levelColors[below], levelColors[below + 1], step - float(below));
    }
    return litRelief(color, normalize(facing));
}
