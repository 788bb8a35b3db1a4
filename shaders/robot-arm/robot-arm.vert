uniform mat4 clipFromWorld;
uniform mat4 worldFromModel;
in vec4 position;
in vec3 normal;
out vec3 worldNormal;

// Boxes and cylinders are stretched along their own axes: their normals keep their directions.
void main() {
    gl_Position = clipFromWorld * worldFromModel * position;
    worldNormal = mat3(worldFromModel) * normal;
}
