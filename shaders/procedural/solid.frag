// The pattern of a point, read from a 3D texture: the mean of the eight texels round it, weighted by their distances.
#include "procedural-look.glsl"
uniform sampler3D solid;
in vec3 place;
in vec3 facing;

void main() { showPattern(texture(solid, place).r, facing, true); }
