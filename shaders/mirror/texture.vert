uniform mat4 clipFromSquare;
in vec4 position;

void main() { gl_Position = clipFromSquare * position; }
