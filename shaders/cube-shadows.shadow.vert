uniform mat4 clipFromView;
uniform mat4 viewFromModel;
uniform vec4 beforePlane;  // half spaces in model space
uniform vec4 beforeLight;
in vec4 position;
out vec2 inside;

void main() {
    // Of the point that casts the shadow, not of the shadow. Where one of the two is negative, GL cuts the triangle off.
    inside = vec2(dot(beforePlane, position), dot(beforeLight, position));
#ifndef GL_ES
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
#endif
    gl_Position = clipFromView * viewFromModel * position;
}
