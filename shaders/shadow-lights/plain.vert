uniform mat4 clipFromObject;
in vec4 position;

invariant gl_Position;  // as in shadow-lights.vert

void main() { gl_Position = clipFromObject * position; }
