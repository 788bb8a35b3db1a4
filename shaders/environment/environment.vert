// The body that mirrors.
uniform mat4 clipFromBody, worldFromBody;
uniform mat3 worldFromNormal;
in vec3 position;
in vec3 normal;
out vec3 place;
out vec3 facing;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    place = vec3(worldFromBody * vec4(position, 1.0));
    facing = worldFromNormal * normal;
}
