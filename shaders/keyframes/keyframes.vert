uniform mat4 clipFromWorld;
in vec4 position;
in vec3 normal;
in vec4 color;
out vec3 vertexColor;

void main() {
    vertexColor = color.rgb * (0.80 + dot(normal, vec3(0.10, 0.18, 0.10)));
    gl_Position = clipFromWorld * position;
}
