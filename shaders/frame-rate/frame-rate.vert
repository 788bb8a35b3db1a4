uniform mat4 clipFromModel;
in vec4 position;
in vec4 color;
out vec4 vertexColor;

void main() {
    vertexColor = color;
    gl_Position = clipFromModel * position;
}
