// A mirror before anything is seen in it: the sky.
#include "seen.glsl"
uniform vec3 sky;

void main() { showSeen(sky, 0.0); }
