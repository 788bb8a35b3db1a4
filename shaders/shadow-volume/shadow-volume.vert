uniform mat4 clipFromObject;
uniform mat4 worldFromObject;
uniform mat3 worldFromNormal;
in vec4 position;
in vec3 normal;
out vec3 worldPoint;
out vec3 worldNormal;

// The light cap of a volume lies in the faces of its solid, and must get exactly their depth: the same product in both
// shaders, and no liberty in computing it.
invariant gl_Position;

void main() {
    gl_Position = clipFromObject * position;
    worldPoint = vec3(worldFromObject * position);
    worldNormal = worldFromNormal * normal;
}
