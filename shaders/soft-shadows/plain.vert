uniform mat4 clipFromObject;
in vec4 position;
invariant gl_Position;

void main() {
    gl_Position = clipFromObject * position;
}
