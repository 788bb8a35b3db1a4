uniform mat4 clipFromView;
uniform mat4 viewFromModel;
in vec4 position;
in vec4 color;
out vec4 vertexColor;

void main() {
    vertexColor = color;
    gl_Position = clipFromView * viewFromModel * position;
}
