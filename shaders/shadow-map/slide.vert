uniform mat4 clipFromObject;
uniform mat4 worldFromObject;
uniform mat4 mapFromObject;
in vec4 position;
in vec3 normal;
in vec2 texCoord;
out vec3 worldPoint;
out vec3 worldNormal;
out vec2 uv;
out vec4 onMap;

void main() {
    gl_Position = clipFromObject * position;
    worldPoint = vec3(worldFromObject * position);
    worldNormal = mat3(worldFromObject) * normal;  // objects are turned and moved, not stretched
    uv = texCoord;
    onMap = mapFromObject * position;
}
