uniform mat4 clipFromWorld;
in vec4 position;
in vec3 normal;
in vec4 color;
out vec4 vertexColor;

void main() {
    // Each of the six main directions has a shade of its own: top bright, front less so, side darker.
    float shade = 0.80 + dot(normal, vec3(-0.08, 0.20, 0.10));
    vertexColor = vec4(shade * color.rgb, 1.0);
    gl_Position = clipFromWorld * position;
}
