// A ball about one lamp, as large as its reach.
uniform mat4 clipFromBall;
in vec3 position;

void main() { gl_Position = clipFromBall * vec4(position, 1.0); }
