uniform mat4 clipFromObject;
uniform mat4 worldFromObject;
in vec4 position;
in vec3 normal;
out vec3 worldPoint;
out vec3 worldNormal;

// The light cap of a volume must get exactly the depth of the faces it lies in: see flat.vert.
invariant gl_Position;

void main() {
    gl_Position = clipFromObject * position;
    worldPoint = vec3(worldFromObject * position);
    worldNormal = mat3(worldFromObject) * normal;  // objects are turned and moved, not stretched
}
