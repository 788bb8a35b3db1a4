// Walls and balls of the room.
uniform mat4 clipFromObject, worldFromObject;
in vec3 position;
in vec3 normal;
out vec3 point;
out vec3 facing;

void main() {
    gl_Position = clipFromObject * vec4(position, 1.0);
    point = vec3(worldFromObject * vec4(position, 1.0));
    facing = normal;
}
