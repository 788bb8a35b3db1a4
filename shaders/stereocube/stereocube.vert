uniform mat4 clipFromModel;
in vec4 position;

void main() { gl_Position = clipFromModel * position; }
