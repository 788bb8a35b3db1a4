uniform mat4 paneFromModel;
in vec4 position;

void main() { gl_Position = paneFromModel * position; }
