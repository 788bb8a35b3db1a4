// The values that may be interpolated along the picture: u/w, v/w and 1/w.
#include "along-picture.glsl"
uniform mat4 clipFromModel;
in vec4 position;
in vec2 texCoord;
AlongPicture out vec3 overW;

void main() {
    vec4 clip = clipFromModel * position;
    overW = vec3(texCoord, 1.0) / clip.w;
    gl_Position = alongPicture(clip);
}
