uniform mat4 clipFromWorld;
in vec3 position;
in vec3 normal;
in vec4 color;
out vec3 worldPoint;
out vec3 worldNormal;
out vec3 ownColor;

void main() {
    gl_Position = clipFromWorld * vec4(position, 1.0);
    worldPoint = position;
    worldNormal = normal;
    ownColor = color.rgb;
}
