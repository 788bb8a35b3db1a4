// A map, flat, over a pane.
in vec3 position;
in vec2 texCoord;
out vec2 place;

void main() {
    place = texCoord;
    gl_Position = vec4(2.0 * position.x, -2.0 * position.z, 0.0, 1.0);
}
