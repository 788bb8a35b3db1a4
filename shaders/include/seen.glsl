// The number that a study of mirrors compares: which object is seen, as a whole number, and how bright, as a fraction.
#include "measure.glsl"

void showSeen(vec3 light, float number) { show(light, number + 0.9 * dot(light, vec3(1.0 / 3.0)), true); }
