// A mesh that was displaced before it came here.
uniform mat4 clipFromBody;
uniform float cells;  // that a patch was cut into, along each side
in vec3 position;
in vec3 normal;
in vec2 texCoord;
out vec3 point;
out vec3 facing;
out vec2 place;
out float level;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    point = position;
    facing = normal;
    place = texCoord;
    level = cells;
}
