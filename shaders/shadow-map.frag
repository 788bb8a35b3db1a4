#include "light.glsl"
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
uniform bool measuring;    // the lit fraction as a number, instead of a picture

in vec3 worldPoint;
in vec3 worldNormal;
in vec2 uv;
in vec4 onMap;
out vec4 fragColor;

void main() {
    float lit = litPcf(map, onMap, bias, taps);
    if (measuring) {
        fragColor = vec4(facesLight(worldPoint, light) ? lit : -1.0);
        return;
    }
    vec3 toLight = towardsLight(worldPoint, light);
    vec3 normal = normalize(worldNormal);
    lit *= smoothstep(spotCosines.x, spotCosines.y, dot(-toLight, spotAxis));
    vec3 surface = checkered && mod(floor(8.0 * uv.x) + floor(8.0 * uv.y), 2.0) == 1.0 ? 0.8 * color : color;
    vec3 halfway = normalize(toLight + normalize(eye - worldPoint));
    float highlight = pow(max(dot(normal, halfway), 0.0), 150.0);
    fragColor = vec4(shade(surface, worldPoint, normal, light, lit) + lit * highlight, 1);
}
