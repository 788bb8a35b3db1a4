#include "measure.glsl"
#include "srgb.glsl"

const int directional = 0, point = 1, spot = 2;

// Only the lights that are on and that reach, all in world space:
uniform int count;
uniform int kind[8];
uniform vec3 place[8];      // of a lamp; of a directional light the unit vector towards it
uniform vec3 power[8];      // its colour and strength, in linear light
uniform vec3 ambient;
uniform vec3 falloff;       // constant, linear, quadratic
uniform float size;         // radius of a lamp
uniform float reach;        // beyond this a lamp is cut off
uniform vec3 axis[8];       // the way a spot shines
uniform float innerCosine;  // of the cone that is lit fully
uniform float outerCosine;  // of the cone outside of which nothing is lit
uniform vec3 color;         // of the surface
uniform bool encode;
in vec3 worldPoint;
in vec3 worldNormal;

// Neither branch divides where both cones are one.
float spotEdge(float cosine) {
    if (cosine >= innerCosine) return 1.0;
    if (cosine <= outerCosine) return 0.0;
    float t = (cosine - outerCosine) / (innerCosine - outerCosine);
    return t * t * (3.0 - 2.0 * t);
}

// The light of one of them that arrives on a surface with this normal: Lambert's cosine, 0 for what faces away.
vec3 arriving(int i, vec3 normal) {
    if (kind[i] == directional) return power[i] * max(dot(normal, place[i]), 0.0);

    // Within the lamp the distance stays at its radius, and towards it is shorter than a unit vector: no 0/0 at its middle
    vec3 toLamp = place[i] - worldPoint;
    float d = max(length(toLamp), size);
    if (d > reach) return vec3(0.0);
    vec3 towards = toLamp / d;
    vec3 light = power[i] * max(dot(normal, towards), 0.0) / (falloff.x + falloff.y * d + falloff.z * d * d);
    return kind[i] == spot ? light * spotEdge(dot(-towards, axis[i])) : light;
}

void main() {
    vec3 normal = normalize(worldNormal);
    vec3 light = ambient;
    for (int i = 0; i < count; ++i) light += arriving(i, normal);
    show(encode ? srgbFromLinear(color * light) : color * light, (light.r + light.g + light.b) / 3.0, true);
}
