// Affine: nothing is divided.
#include "along-picture.glsl"
#include "texture-map.glsl"
AlongPicture in vec2 uv;

void main() {
    showTexel(uv);
}
