uniform vec4 paint;
out vec4 fragColor;

void main() { fragColor = paint; }
