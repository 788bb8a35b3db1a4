uniform mat4 clipFromObject;
uniform mat4 worldFromObject;
uniform mat4 mapFromObject;
in vec4 position;
out vec3 point;
out vec4 onMap;
invariant gl_Position;

void main() {
    point = (worldFromObject * position).xyz;
    onMap = mapFromObject * position;
    gl_Position = clipFromObject * position;
}
