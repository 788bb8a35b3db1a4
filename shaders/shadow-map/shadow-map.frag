#include "light.glsl"
#include "measure.glsl"
#include "shadow-map.glsl"

uniform sampler2DShadow map;
uniform int taps;          // looks along a side: 1, 3, 5 or 7
uniform float bias;        // in depth units of the map
uniform vec4 light;        // world space, homogeneous
uniform vec3 spotAxis;     // the way the spot light looks, unit length
uniform vec2 spotCosines;  // of its outer and inner limit
uniform vec3 eye;          // world space
uniform vec3 color;
uniform bool checkered;

in vec3 worldPoint;
in vec3 worldNormal;
in vec2 uv;
in vec4 onMap;

void main() {
    float unshadowed = litPcf(map, onMap, bias, taps);
    vec3 toLight = towardsLight(worldPoint, light);
    vec3 normal = normalize(worldNormal);
    float lit = unshadowed * smoothstep(spotCosines.x, spotCosines.y, dot(-toLight, spotAxis));
    vec3 surface = checkered && mod(floor(8.0 * uv.x) + floor(8.0 * uv.y), 2.0) == 1.0 ? 0.8 * color : color;
    vec3 halfway = normalize(toLight + normalize(eye - worldPoint));
    float highlight = pow(max(dot(normal, halfway), 0.0), 150.0);
    vec3 seen = shade(surface, worldPoint, normal, light, lit) + lit * highlight;
    show(seen, unshadowed, facesLight(worldPoint, light));
}
