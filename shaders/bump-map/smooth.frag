// No bumps: what is painted on the surface, and its own normals. So is a displaced mesh lit, which has the bumps itself.
#include "relief.glsl"

void main() { showLit(texture(painted, place).rgb, normalize(facing)); }
