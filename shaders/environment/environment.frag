// Light that a body reflects and lets through, looked up in a cube map or found by rays.
#include "fresnel.glsl"
#include "surroundings.glsl"
#include "measure.glsl"
uniform samplerCube cube;
uniform vec3 eye;
uniform bool bySchlick;
uniform int lookup;        // 0 by direction, 1 by where the ray meets the room's walls, 2 rays
uniform float raysFrom;    // the column of pixels from which on all is exact
uniform bool isSphere;     // of radius 1 about the origin
uniform int waysOut;       // of light in the glass: 0 it is looked up where it goes in, 1 where it goes out, 2 and inside once ...
in vec3 place;
in vec3 facing;

bool isExact() { return gl_FragCoord.x >= raysFrom; }

vec3 lightFrom(vec3 from, vec3 way) {
    if (lookup == 2 || isExact()) return seenAlong(from, way);
    return texture(cube, lookup == 1 ? wallAlong(from, way) : way).rgb;
}

// The light that comes through the glass, of which each surface reflects `back` and lets the rest pass: in a sphere,
// light meets it at the same angle each time.
vec3 lightThrough(vec3 point, vec3 v, vec3 n, float back) {
    vec3 way = refracted(-v, n, index), light = vec3(0.0);
    int ways = isSphere && isExact() ? 5 : waysOut;
    if (ways == 0) return (1.0 - back) * lightFrom(point, way);
    float part = 1.0 - back;
    for (int i = 0; i < ways; ++i) {
        vec3 end = normalize(n - 2.0 * dot(n, way) * way);
        light += part * (1.0 - back) * lightFrom(end, refracted(way, -end, 1.0 / index));
        part *= back;
        way = reflect(way, end);
        n = end;
    }
    return light;
}

// The point where the line of sight meets the sphere, of which the mesh has corners only. v points to the eye.
vec3 onSphere(vec3 v) {
    vec3 miss = cross(eye, v);
    return normalize(eye - (dot(eye, v) - sqrt(max(1.0 - dot(miss, miss), 0.0))) * v);
}

void main() {
    vec3 v = normalize(eye - place);
    vec3 point = isSphere ? onSphere(v) : place;
    vec3 n = isSphere ? point : normalize(facing);
    // At a mesh's outline the interpolated normal may turn away from the eye, as no visible surface does.
    float cosine = clamp(dot(n, v), 0.0, 1.0);
    vec3 part = fresnel(cosine, bySchlick && !isExact());
    vec3 light = part * lightFrom(point, reflect(-v, n));
    if (material == 2 && part.x < 1.0) light += lightThrough(point, v, n, part.x);
    show(light, dot(light, vec3(0.2126, 0.7152, 0.0722)), isSphere && length(cross(eye, v)) < 0.95);
}
