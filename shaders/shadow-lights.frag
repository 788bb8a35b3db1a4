#include "light.glsl"
#include "shadow-map.glsl"

uniform bool ambientPass;  // the first pass: no light yet
uniform vec4 light;        // world space, homogeneous
uniform vec3 lightColor;
uniform float reach;       // beyond this distance the light gives nothing
uniform bool byMap;        // else the stencil test has left out what is in shadow
uniform bool shaded;       // a lamp with a shade, which darkens all that its map does not hold
uniform sampler2DShadow map;
uniform vec3 color;
uniform bool measuring;    // the mean lit fraction as a number, instead of a picture
uniform float share;       // of one light in that mean
uniform vec4 firstLight;   // that decides which pixels count
in vec3 worldPoint;
in vec3 worldNormal;
in vec4 onMap;
out vec4 fragColor;

// Whether the triangle's front faces a light: its own normal, not the smooth one of the shading.
bool faces(vec3 normal, vec4 towards) { return (dot(normal, towardsLight(worldPoint, towards)) > 0.0) == gl_FrontFacing; }

void main() {
    vec3 facet = cross(dFdx(worldPoint), dFdy(worldPoint));  // towards the eye
    float lit = 1.0;
    if (byMap && !ambientPass) lit = shaded && !isOnMap(onMap) ? 0.0 : litOneTap(map, onMap, 0.0);
    if (measuring) {
        bool counts = faces(facet, firstLight);
        fragColor = vec4(ambientPass ? (counts ? 0.0 : -1.0) : counts && faces(facet, light) ? share * lit : 0.0);
    } else if (ambientPass) {
        fragColor = vec4(ambientShare * color, 1.0);
    } else {
        float part = min(distance(worldPoint, light.xyz) / reach, 1.0);
        float falloff = (1.0 - part * part) * (1.0 - part * part);
        fragColor = vec4(color * lightColor * falloff * lit * diffuse(worldPoint, normalize(worldNormal), light), 1.0);
    }
}
