#include "surroundings.glsl"
uniform int ball;  // which one; -1: the walls
in vec3 point;
in vec3 facing;
out vec4 fragColor;

void main() {
    fragColor = vec4(ball < 0 ? wallColor(point / room) : ballLight(ballColor[ball], normalize(facing)), 1.0);
}
