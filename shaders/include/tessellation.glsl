// The levels of tessellation: into how many pieces an edge is cut. mv/geometry/tessellation.h has the same rule in C++.

// Every driver takes levels up to this one.
const float largestLevel = 64.0;

// The level that is drawn where `wanted` is asked for: in 1 .. 64. A level that is not above 1 is 1, and so is one that
// is no number: OpenGL leaves out a whole patch one of whose outer levels is 0, and a hole is never what a level was
// meant to say. Who wants a patch left out sets all of its levels to 0 instead of asking here.
float levelInRange(float wanted) { return wanted > 1.0 ? min(wanted, largestLevel) : 1.0; }

// The outer level of an edge from a to b as the eye sees it: `fineness` pieces where it is as long as it is far away.
// The level reads nothing but the edge, and is the same from b to a, bit for bit: so two patches that share an edge cut
// it alike, and there is no crack between them, whatever levels their other edges and their insides have.
float edgeLevel(vec3 a, vec3 b, vec3 eye, float fineness) {
    return levelInRange(fineness * distance(a, b) / distance(0.5 * (a + b), eye));
}
