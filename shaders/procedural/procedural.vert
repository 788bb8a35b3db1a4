// A body whose pattern belongs to its points.
uniform mat4 clipFromBody, viewFromBody, offsetFromBody;
in vec3 position;
in vec3 normal;
out vec3 offset;
out vec3 facing;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    facing = mat3(viewFromBody) * normal;
    offset = vec3(offsetFromBody * vec4(position, 1.0));
}
