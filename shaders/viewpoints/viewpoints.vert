uniform mat4 clipFromView;
uniform mat4 viewFromModel;
in vec4 position;
out vec3 viewPoint;

void main() {
    gl_Position = clipFromView * viewFromModel * position;
    viewPoint = vec3(viewFromModel * position);
}
