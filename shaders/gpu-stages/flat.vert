// Vertices of the plane as they are; each primitive has the colour of one of its own.
uniform mat4 clipFromPane;
in vec3 position;
in vec4 color;
flat out vec4 own;

void main() {
    gl_Position = clipFromPane * vec4(position, 1.0);
    gl_PointSize = 9.0;
    own = color;
}
