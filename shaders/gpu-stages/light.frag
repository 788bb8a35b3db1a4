// The rays that the compute shader counted in each texel. 16 are the mean.
uniform highp usampler2D image;
uniform vec2 corner;
out vec4 fragColor;

void main() {
    float light = float(texelFetch(image, ivec2(gl_FragCoord.xy - corner), 0).r) / 16.0;
    fragColor = vec4(mix(vec3(0.0, 0.15, 0.25), vec3(1.0), min(0.25 * light, 1.0)), 1.0);
}
