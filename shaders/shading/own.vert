// A colour of its own, whatever the light: the body without shading, and its normals as lines.
uniform mat4 clipFromBody;
in vec3 position;

void main() { gl_Position = clipFromBody * vec4(position, 1.0); }
