uniform mat4 clipFromView;
uniform mat4 viewFromModel;
uniform vec4 beforePlane;  // half spaces in model space
uniform vec4 beforeLight;
uniform int cut;  // 0 clip, 1 discard, 2 none
in vec4 position;
out vec2 inside;

void main() {
    // Distances of the point that casts the shadow, not of the shadow. GL cuts the triangle off where one of the two is
    // negative.
    inside = vec2(dot(beforePlane, position), dot(beforeLight, position));
#ifndef GL_ES
    // Mesa's llvmpipe cuts by what is written here even where GL_CLIP_DISTANCE0 and 1 are disabled.
    gl_ClipDistance[0] = cut == 0 ? inside.x : 1.0;
    gl_ClipDistance[1] = cut == 0 ? inside.y : 1.0;
#endif
    gl_Position = clipFromView * viewFromModel * position;
}
