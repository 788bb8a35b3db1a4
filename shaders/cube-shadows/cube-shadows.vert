uniform mat4 clipFromView;
uniform mat4 viewFromModel;
in vec4 position;
in vec3 normal;
in vec4 color;
out vec3 viewPoint;
out vec3 viewNormal;
out vec4 ownColor;

void main() {
    vec4 point = viewFromModel * position;
    viewPoint = point.xyz;
    viewNormal = mat3(viewFromModel) * normal;  // what is lit is turned, and scaled alike in all directions
    ownColor = color;
    gl_Position = clipFromView * point;
}
