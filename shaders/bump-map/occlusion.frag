// Parallax occlusion mapping (Tatarchuk 2006): down along the line of sight in layers, until it is below the height map.
#include "parallax.glsl"
uniform int layers;

void main() {
    mat3 frame = bodyFromFrame();
    vec2 whole = shiftDown(frame), across = dFdx(place), up = dFdy(place);
    float part = 0.0, before = 0.0, above = 1.0 - textureGrad(painted, place, across, up).a;
    for (int i = 1; i <= layers && above > 0.0; ++i) {
        before = above;
        part = float(i) / float(layers);
        above = 1.0 - part - textureGrad(painted, place + part * whole, across, up).a;
    }
    // Between the last two layers both line and relief are taken as straight.
    if (above < 0.0) part += above / ((before - above) * float(layers));
    showAt(place + part * whole, across, up, frame);
}
