uniform mat4 clipFromObject;
uniform mat4 mapFromObject;
in vec4 position;
out vec4 onMap;
invariant gl_Position;

void main() {
    onMap = mapFromObject * position;
    gl_Position = clipFromObject * position;
}
