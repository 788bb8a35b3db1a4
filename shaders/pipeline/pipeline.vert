uniform mat4 worldFromModel;
uniform mat4 cameraFromWorld;
uniform mat4 clipFromCamera;
uniform int wanted;  // 0 clip, to draw; to read back also 1 world, 2 camera
in vec4 position;
in vec4 color;
out vec4 vertexColor;

void main() {
    vec4 world = worldFromModel * position;
    vec4 camera = cameraFromWorld * world;
    vec4 clip = clipFromCamera * camera;
    vertexColor = color;
    gl_Position = wanted == 0 ? clip : wanted == 1 ? world : camera;
    gl_PointSize = 9.0;
}
