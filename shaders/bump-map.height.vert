#include "bumped-vertex.glsl"
