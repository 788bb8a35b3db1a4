in float growth;
out vec4 fragColor;

// Blue where nothing grows, the darker the faster it falls asleep; a line where it does neither.
void main() {
    float pixel = max(fwidth(growth), 1e-6);
    vec3 inside = mix(vec3(0.45, 0.65, 0.85), vec3(0.88, 0.94, 1.0), clamp(1.0 + growth, 0.0, 1.0));
    vec3 color = mix(inside, vec3(1.0), smoothstep(-0.5, 0.5, growth / pixel));
    float line = 1.0 - smoothstep(0.5, 1.5, abs(growth) / pixel);
    fragColor = vec4(mix(color, vec3(0.1, 0.3, 0.7), line), 1.0);
}
