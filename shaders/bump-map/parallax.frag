// Parallax mapping (Kaneko 2001): as if the height here were the height where the line of sight meets the relief.
#include "parallax.glsl"

void main() {
    mat3 frame = bodyFromFrame();
    float height = texture(painted, place).a;
    showAt(place + (1.0 - height) * shiftDown(frame), dFdx(place), dFdy(place), frame);
}
