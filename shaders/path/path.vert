uniform mat4 clipFromWorld;
uniform mat4 worldFromModel;  // scales all axes alike
in vec4 position;
in vec3 normal;
in vec4 color;
out vec4 vertexColor;

void main() {
    // Seen from both sides, lit from above and a little from the side.
    vec3 worldNormal = normalize(mat3(worldFromModel) * normal);
    float shade = 0.72 + 0.28 * abs(dot(worldNormal, normalize(vec3(0.3, 1.0, 0.45))));
    vertexColor = vec4(shade * color.rgb, 1.0);
    gl_Position = clipFromWorld * worldFromModel * position;
}
