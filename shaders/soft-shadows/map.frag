// One point of the lamp: how much of its light the map keeps from here, times that point's share of the lamp.
#include "shadow-map.glsl"
uniform sampler2DShadow map;
uniform vec3 light;   // the point
uniform float share;  // 1 / the number of points
uniform int side;     // looks at side x side texels (percentage-closer filtering); 1: at one
in vec3 point;
in vec4 onMap;
out vec4 fragColor;

void main() {
    // The lamp may be seen by one part of a surface's horizon only: what turns away from this point is dark.
    vec3 normal = cross(dFdx(point), dFdy(point));
    bool away = dot(normal, light - point) <= 0.0;
    fragColor = vec4(share * (away ? 1.0 : 1.0 - litPcf(map, onMap, 0.0, side)));
}
