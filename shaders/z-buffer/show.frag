uniform sampler2D drawn;  // the colours, or the depths, which are in red alone
uniform bool grey;
out vec4 fragColor;

void main() {
    vec4 texel = texelFetch(drawn, ivec2(gl_FragCoord.xy), 0);
    fragColor = grey ? vec4(texel.rrr, 1.0) : vec4(texel.rgb, 1.0);
}
