uniform vec2 pixels;   // of the small picture
in vec3 position;      // in pixels from its lower left corner, and w
in vec4 color;
out vec3 shade;

void main() {
    shade = color.rgb;
    gl_Position = vec4((2.0 * position.xy / pixels - 1.0) * position.z, 0.0, position.z);
}
