uniform float darkness;
uniform int cut;  // 0 clip, 1 discard, 2 none
in vec2 inside;
out vec4 fragColor;

void main() {
    if (cut == 1 && min(inside.x, inside.y) <= 0.0) discard;
    fragColor = vec4(vec3(1.0 - darkness), 1.0);  // what is there is multiplied by this
}
