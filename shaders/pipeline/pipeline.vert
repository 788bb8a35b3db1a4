uniform mat4 worldFromModel;
uniform mat4 cameraFromWorld;
uniform mat4 clipFromCamera;
uniform int wanted;  // 0 world, 1 camera, 2 clip: clip to draw, the others to read back
in vec4 position;
in vec4 color;
out vec4 vertexColor;

void main() {
    vec4 world = worldFromModel * position;
    vec4 camera = cameraFromWorld * world;
    vec4 clip = clipFromCamera * camera;
    vertexColor = color;
    gl_Position = wanted == 0 ? world : wanted == 1 ? camera : clip;
    gl_PointSize = 9.0;
}
