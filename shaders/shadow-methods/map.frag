#include "light.glsl"
#include "measure.glsl"
#include "shadow-map.glsl"

uniform sampler2DShadow map;
uniform int side;    // looks along a side: 1, 3 or 5
uniform vec4 light;  // world space, homogeneous
uniform vec3 color;
in vec3 worldPoint;
in vec3 worldNormal;
in vec4 onMap;

void main() {
    float lit = litPcf(map, onMap, 0.0, side);
    show(shade(color, worldPoint, normalize(worldNormal), light, lit), lit, facesLight(worldPoint, light));
}
