// A body that is cut out of a 3D texture: a matrix makes the point the texture's coordinates.
uniform mat4 clipFromBody, viewFromBody, textureFromBody;
in vec3 position;
in vec3 normal;
out vec3 place;  // 0..1
out vec3 facing;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    facing = mat3(viewFromBody) * normal;
    place = vec3(textureFromBody * vec4(position, 1.0));
}
