uniform vec4 color;
in float heightAbovePlane;
in float depthBelowLight;
out vec4 fragColor;

void main() {
    if (heightAbovePlane <= 0.0 || depthBelowLight <= 0.0) discard;
    fragColor = color;
}
