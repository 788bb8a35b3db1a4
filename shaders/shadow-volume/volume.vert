uniform mat4 clipFromObject;
in vec4 position;  // w = 1: a point; w = 0: at infinity

invariant gl_Position;  // as in shadow-volume.vert

void main() { gl_Position = clipFromObject * position; }
