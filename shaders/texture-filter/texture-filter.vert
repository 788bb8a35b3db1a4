// The floor: its points carry texture coordinates, in repeats of the texture.
uniform mat4 clipFromFloor;
in vec4 position;
out vec2 place;

void main() {
    place = vec2(position.x, -position.z);
    gl_Position = clipFromFloor * position;
}
