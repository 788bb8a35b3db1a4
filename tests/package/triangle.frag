out vec4 fragColor;
void main() { fragColor = vec4(1.0, 0.6, 0.0, 1.0); }
