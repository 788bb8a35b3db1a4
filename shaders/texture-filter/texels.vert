// A part of the texture, flat, over a pane.
uniform vec2 low;   // its corners, in repeats
uniform vec2 high;
in vec4 position;
out vec2 place;

void main() {
    place = mix(low, high, 0.5 + 0.5 * position.xy);
    gl_Position = position;
}
