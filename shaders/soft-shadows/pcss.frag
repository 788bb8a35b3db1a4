// Percentage-closer soft shadows (Fernando 2005): one map, drawn from the middle of the lamp. Seen from here the lamp is
// the base of a pyramid, and what cuts that pyramid keeps light away.
uniform sampler2D map;
uniform vec4 mapLamp, mapHalfU, mapHalfV;  // mapFromWorld times the lamp's middle and its two half sides
uniform float near, far;                   // of the map
uniform bool isDisc;                       // not the whole parallelogram, but the ellipse in it
uniform int side;                          // looks at side x side places of the map, twice
in vec4 onMap;
out vec4 fragColor;

// The gain of this surface's depth by a step of the map's two coordinates: a plane in the world is one on the map too,
// so two neighbouring pixels tell.
vec2 slopeOf(vec3 at) {
    vec3 right = dFdx(at), up = dFdy(at);
    return vec2(up.y * right.z - right.y * up.z, right.x * up.z - up.x * right.z) / (right.x * up.y - right.y * up.x);
}

vec2 placeOf(int i, int j) { return (2.0 * vec2(i, j) + 1.0) / float(side) - 1.0; }
bool isOnLamp(int i, int j) { return !isDisc || dot(placeOf(i, j), placeOf(i, j)) <= 1.0; }

// The map's depth at the part `way` of the way from here to the place (i, j) of the lamp, or 1 where that is no caster:
// it is not in front of this surface, whose own depth there tells (what lies beyond the map's end is at its end).
float casterSeen(int i, int j, float way, vec2 slope) {
    vec2 place = placeOf(i, j);
    vec4 at = mix(onMap, mapLamp + place.x * mapHalfU + place.y * mapHalfV, way);
    float depth = textureLod(map, at.xy / at.w, 0.0).r;
    float own = onMap.z / onMap.w + dot(slope, at.xy / at.w - onMap.xy / onMap.w);
    return depth < min(own, 1.0) ? depth : 1.0;
}

// The distance from the lamp's plane, of a depth 0..1 of the map.
float distanceOf(float depth) { return near * far / (far - depth * (far - near)); }

void main() {
    vec2 slope = slopeOf(onMap.xyz / onMap.w);
    float here = onMap.w;  // the distance from the lamp's plane

    // 1. Search: how far from the lamp are, on average, the casters in the pyramid? The search is cut where the map
    // begins.
    float sum = 0.0, found = 0.0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            if (!isOnLamp(i, j)) continue;
            float depth = casterSeen(i, j, 1.0 - near / here, slope);
            if (depth == 1.0) continue;
            sum += distanceOf(depth);
            found += 1.0;
        }
    }
    if (found == 0.0) {
        fragColor = vec4(0.0);
        return;
    }

    // 2. Estimate: all of them stand at that distance. 3. Filter: look again where the pyramid is cut there.
    float dark = 0.0, asked = 0.0, way = 1.0 - sum / found / here;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            if (!isOnLamp(i, j)) continue;
            asked += 1.0;
            dark += casterSeen(i, j, way, slope) < 1.0 ? 1.0 : 0.0;
        }
    }
    fragColor = vec4(dark / asked);
}
