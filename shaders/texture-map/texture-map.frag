// Perspective-correct: the driver has divided.
#include "texture-map.glsl"
in vec2 uv;

void main() {
    showTexel(uv);
}
