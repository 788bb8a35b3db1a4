uniform vec4 color;
in float across;
out vec4 fragColor;

void main() {
    // A darker rim on both sides, so that one sees which plate passes over which
    float shade = abs(across) > 0.42 ? 0.7 : 1.0;
    fragColor = vec4(shade * color.rgb, color.a);
}
