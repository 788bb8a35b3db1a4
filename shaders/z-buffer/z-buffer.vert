uniform mat4 clipFromView;
uniform mat4 viewFromPlate;
in vec4 position;
out float across;  // from -0.5 to 0.5 over the plate's width

void main() {
    across = position.y;
    gl_Position = clipFromView * (viewFromPlate * position);
}
