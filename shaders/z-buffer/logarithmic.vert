uniform mat4 clipFromView;
uniform mat4 viewFromPlate;
in vec4 position;
out float across;  // from -0.5 to 0.5 over the plate's width
out float ahead;   // the distance from the eye, along its gaze

void main() {
    across = position.y;
    gl_Position = clipFromView * (viewFromPlate * position);
    ahead = gl_Position.w;
}
