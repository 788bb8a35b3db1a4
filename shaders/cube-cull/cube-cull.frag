#include "measure.glsl"
in vec4 vertexColor;

// A study asks for the distance along the gaze, which is w in clip space.
void main() { show(vertexColor.rgb, 1.0 / gl_FragCoord.w, true); }
