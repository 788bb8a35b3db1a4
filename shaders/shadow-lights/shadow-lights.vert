uniform mat4 clipFromObject;
uniform mat4 worldFromObject;
uniform mat3 worldFromNormal;
uniform mat4 mapFromObject;
in vec4 position;
in vec3 normal;
out vec3 worldPoint;
out vec3 worldNormal;
out vec4 onMap;

// Each light is added to the pixels of the same depth, and caps of volumes lie in the faces: the same product everywhere.
invariant gl_Position;

void main() {
    gl_Position = clipFromObject * position;
    worldPoint = vec3(worldFromObject * position);
    worldNormal = worldFromNormal * normal;
    onMap = mapFromObject * position;
}
