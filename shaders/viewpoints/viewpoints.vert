uniform mat4 clipFromView;
uniform mat4 viewFromModel;
in vec4 position;

void main() { gl_Position = clipFromView * viewFromModel * position; }
