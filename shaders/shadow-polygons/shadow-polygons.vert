uniform mat4 clipFromWorld;
in vec4 position;
in vec3 normal;
in vec4 color;
out vec3 worldPoint;
out vec3 worldNormal;
out vec3 surface;

void main() {
    gl_Position = clipFromWorld * position;
    worldPoint = vec3(position);
    worldNormal = normal;
    surface = vec3(color);
}
