uniform float darkness;
uniform bool discardOutside;
in vec2 inside;
out vec4 fragColor;

void main() {
    if (discardOutside && min(inside.x, inside.y) <= 0.0) discard;
    fragColor = vec4(0.0, 0.0, 0.0, darkness);
}
