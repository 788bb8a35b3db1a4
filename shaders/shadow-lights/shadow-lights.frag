#include "light.glsl"
#include "measure.glsl"
#include "shadow-map.glsl"

uniform bool ambientPass;  // the first pass: no light yet
uniform vec4 light;        // world space, homogeneous
uniform vec3 lightColor;
uniform float reach;       // beyond this distance the light gives nothing
uniform bool byMap;        // else the stencil test has left out what is in shadow
uniform bool hasShade;     // a lamp with a shade, which darkens all that its map does not hold
uniform sampler2DShadow map;
uniform vec3 color;
// A study measures the mean over the lights of the lit fraction:
uniform float share;       // of one light in that mean
uniform vec4 firstLight;   // that decides which pixels count
in vec3 worldPoint;
in vec3 worldNormal;
in vec4 onMap;

void main() {
    if (ambientPass) {
        show(ambientShare * color, 0.0, facesLight(worldPoint, firstLight));
        return;
    }
    bool counts = facesLight(worldPoint, firstLight) && facesLight(worldPoint, light);
    float lit = 1.0;
    if (byMap) lit = hasShade && !isOnMap(onMap) ? 0.0 : litOneTap(map, onMap, 0.0);
    float part = min(distance(worldPoint, light.xyz) / reach, 1.0);
    float falloff = (1.0 - part * part) * (1.0 - part * part);
    show(color * lightColor * falloff * lit * diffuse(worldPoint, normalize(worldNormal), light),
         counts ? share * lit : 0.0, true);
}
