// A study asks which pixels the surface covers.
#include "displaced.glsl"

void main() { show(srgbFromLinear(litHere()), 1.0, true); }
