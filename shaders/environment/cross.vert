// A pane that shows the six faces laid out.
in vec4 position;
out vec2 place;  // in faces, from the lower left corner: 4 x 3

void main() {
    place = (0.5 + 0.5 * position.xy) * vec2(4.0, 3.0);
    gl_Position = position;
}
