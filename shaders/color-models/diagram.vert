uniform mat4 clipFromXy;
in vec4 position;
out vec2 xy;

void main() {
    xy = position.xy;
    gl_Position = clipFromXy * vec4(xy, 0.0, 1.0);
}
