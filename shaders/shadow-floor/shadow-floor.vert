uniform mat4 clipFromView;
uniform mat4 viewFromModel;
uniform mat4 shadowFromModel;
in vec4 position;
out vec4 shadow;

void main() {
    shadow = shadowFromModel * position;
    gl_Position = clipFromView * viewFromModel * position;
}
