uniform mat4 clipFromEye;
uniform mat4 eyeFromModel;
in vec4 position;

void main() { gl_Position = clipFromEye * eyeFromModel * position; }
