uniform vec4 color;
uniform float far;
in float across;
in float ahead;
out vec4 fragColor;

void main() {
    float shade = abs(across) > 0.42 ? 0.7 : 1.0;
    fragColor = vec4(shade * color.rgb, color.a);
    // No matrix makes a logarithm: each fragment writes its depth itself, and is shaded before it can be discarded
    gl_FragDepth = log2(1.0 + ahead) / log2(1.0 + far);
}
