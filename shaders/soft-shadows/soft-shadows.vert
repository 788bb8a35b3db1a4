// The scene as the eye sees it. `invariant`: plain.vert reaches the same depth bit for bit.
uniform mat4 clipFromObject;
uniform mat4 worldFromObject;
uniform mat3 worldFromNormal;
in vec4 position;
in vec3 normal;
out vec3 point;
out vec3 facing;
invariant gl_Position;

void main() {
    point = (worldFromObject * position).xyz;
    facing = worldFromNormal * normal;
    gl_Position = clipFromObject * position;
}
