uniform vec3 color;
in vec3 worldNormal;
out vec4 fragColor;

const vec3 toLight = vec3(0.36, 0.80, 0.48);

void main() {
    float lit = max(dot(normalize(worldNormal), toLight), 0.0);
    fragColor = vec4(color * (0.6 + 0.4 * lit), 1.0);
}
