// What the study asks of each pixel: how far away along the gaze, which is w in clip space.
out vec4 fragColor;

void main() { fragColor = vec4(1.0 / gl_FragCoord.w); }
