// A body that is lit in its own space: its normals, and the frames of its texture coordinates.
uniform mat4 clipFromBody;
in vec3 position;
in vec3 normal;
in vec2 texCoord;
in vec4 tangent;
out vec3 point;
out vec3 facing;
out vec4 along;
out vec2 place;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    point = position;
    facing = normal;
    along = tangent;
    place = texCoord;
}
