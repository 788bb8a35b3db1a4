uniform mat4 worldFromObject;
uniform mat4 clipFromWorld;  // of the camera
uniform mat4 paneFromWorld;  // of who looks at it
in vec4 position;
in vec3 normal;
in vec4 color;
out vec4 clip;
out vec3 vertexColor;

void main() {
    vec4 world = worldFromObject * position;
    clip = clipFromWorld * world;
    vertexColor = color.rgb * (0.80 + dot(normal, vec3(0.10, 0.18, 0.10)));
    gl_Position = paneFromWorld * world;
}
