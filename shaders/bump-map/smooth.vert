// A body with its own normals alone.
uniform mat4 clipFromBody;
in vec3 position;
in vec3 normal;
in vec2 texCoord;
out vec3 point;
out vec3 facing;
out vec2 place;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    point = position;
    facing = normal;
    place = texCoord;
}
