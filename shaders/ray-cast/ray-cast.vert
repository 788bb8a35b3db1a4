uniform mat4 clipFromScene;
in vec3 position;
in vec3 normal;
out vec3 facing;

void main() {
    gl_Position = clipFromScene * vec4(position, 1.0);
    facing = normal;
}
