// How many units u and v take to grow by 1, here.
uniform vec2 unitsOfRepeat;
uniform bool isRound;       // on a sphere u goes round in less and less the nearer the poles are,
uniform float leastCosine;  // up to where a circle of latitude is one row of texels away from its pole

vec2 unitsHere(vec3 normal) {
    return unitsOfRepeat * vec2(isRound ? max(length(normal.xz), leastCosine) : 1.0, 1.0);
}
