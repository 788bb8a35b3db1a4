#include "light.glsl"
#include "measure.glsl"
#include "shadow-map.glsl"

uniform sampler2D slide;
uniform sampler2DShadow map;
uniform int taps;  // looks along a side: 1, 3, 5 or 7
uniform float bias;
uniform vec4 light;  // world space, homogeneous
uniform vec3 color;
uniform bool checkered;
uniform bool alsoBehind;

in vec3 worldPoint;
in vec3 worldNormal;
in vec2 uv;
in vec4 onMap;

// What the slide lets through to this point. Behind the projector w is below 0, and the division alone would throw the picture there,
// too, upside down.
vec3 thrown() {
    vec2 at = onMap.xy / onMap.w;
    bool isInWindow = all(greaterThanEqual(at, vec2(0.0))) && all(lessThanEqual(at, vec2(1.0)));
    bool isBefore = onMap.w > 0.0;
    return isInWindow && (isBefore || alsoBehind) ? textureLod(slide, at, 0.0).rgb : vec3(0.0);
}

void main() {
    float unshadowed = litPcf(map, onMap, bias, taps);
    vec3 normal = normalize(worldNormal);
    vec3 surface = checkered && mod(floor(8.0 * uv.x) + floor(8.0 * uv.y), 2.0) == 1.0 ? 0.8 * color : color;
    vec3 dark = shade(surface, worldPoint, normal, light, 0.0);
    vec3 lit = shade(surface, worldPoint, normal, light, unshadowed);
    show(mix(dark, lit, thrown()), unshadowed, facesLight(worldPoint, light));
}
