in vec3 position;

void main() { gl_Position = vec4(2.0 * position.x, 2.0 * position.z, 0.0, 1.0); }
