uniform mat4 clipFromObject;
uniform mat4 worldFromObject;
in vec4 position;
in vec3 normal;
out vec3 worldPoint;
out vec3 worldNormal;

void main() {
    gl_Position = clipFromObject * position;
    worldPoint = vec3(worldFromObject * position);
    worldNormal = mat3(worldFromObject) * normal;  // all are made smaller alike, and then of unit length in each fragment
}
