// Phong shading: the normal is handed on, and interpolated over the face.
uniform mat4 clipFromBody, worldFromBody;
uniform mat3 worldFromNormal;
in vec3 position;
in vec3 normal;
out vec3 point;
out vec3 facing;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    point = vec3(worldFromBody * vec4(position, 1.0));
    facing = worldFromNormal * normal;
}
