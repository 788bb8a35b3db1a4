// What a study asks for is which pixels the surface covers.
#include "displaced.glsl"

void main() { show(srgbFromLinear(litHere()), 1.0, true); }
