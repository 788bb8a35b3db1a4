// Texture coordinates that the driver interpolates along the picture.
#include "along-picture.glsl"
uniform mat4 clipFromModel;
in vec4 position;
in vec2 texCoord;
AlongPicture out vec2 uv;

void main() {
    uv = texCoord;
    gl_Position = alongPicture(clipFromModel * position);
}
