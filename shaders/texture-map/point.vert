// The surface point itself; its texture coordinates are found in each pixel.
uniform mat4 clipFromModel;
in vec4 position;
out vec3 point;

void main() {
    point = position.xyz;
    gl_Position = clipFromModel * position;
}
