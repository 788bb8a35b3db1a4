#include "light.glsl"
#include "shadow-map.glsl"

uniform sampler2DShadow map;
uniform int side;        // looks along a side: 1, 3 or 5
uniform vec4 light;      // world space, homogeneous
uniform vec3 color;
uniform bool measuring;  // write the lit part as a number, instead of a picture
in vec3 worldPoint;
in vec3 worldNormal;
in vec4 onMap;
out vec4 fragColor;

void main() {
    float lit = litPcf(map, onMap, 0.0, side);
    if (measuring) {
        fragColor = vec4(facesLight(worldPoint, light) ? lit : -1.0);
    } else {
        fragColor = vec4(shade(color, worldPoint, normalize(worldNormal), light, lit), 1.0);
    }
}
