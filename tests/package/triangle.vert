uniform float extent;
in vec4 position;
void main() { gl_Position = vec4(extent * position.xyz, 1.0); }
