flat in vec4 own;
out vec4 fragColor;

void main() { fragColor = own; }
