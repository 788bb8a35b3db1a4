// Percentage-closer soft shadows (Fernando 2005): one map, drawn from the middle of the lamp. Seen from here the lamp is
// the base of a pyramid, and what cuts that pyramid keeps light away.
uniform sampler2D map;
uniform vec4 mapLamp, mapHalfU, mapHalfV;  // mapFromWorld times the lamp's middle, half its width, half its depth
uniform float near, far;                   // of the map
uniform int side;                          // looks at side x side places of the map, twice
in vec4 onMap;
out vec4 fragColor;

// The distance from the lamp's plane, of a depth 0..1 of the map.
float distanceOf(float depth) { return near * far / (far - depth * (far - near)); }

// The map's depth at the part `way` of the way from here to the place (i, j) of the lamp.
float depthSeen(int i, int j, float way) {
    vec2 place = (2.0 * vec2(i, j) + 1.0) / float(side) - 1.0;
    vec4 at = mix(onMap, mapLamp + place.x * mapHalfU + place.y * mapHalfV, way);
    return textureLod(map, at.xy / at.w, 0.0).r;
}

void main() {
    float depth = onMap.z / onMap.w, here = onMap.w;  // onMap.w is the distance from the lamp's plane

    // 1. Search: how far from the lamp are, on average, the casters in the pyramid? It is cut where the map begins.
    float sum = 0.0, found = 0.0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            float seen = depthSeen(i, j, 1.0 - near / here);
            if (seen >= depth) continue;
            sum += distanceOf(seen);
            found += 1.0;
        }
    }
    if (found == 0.0) {
        fragColor = vec4(0.0);
        return;
    }

    // 2. Estimate: all of them stand at that distance. 3. Filter where the pyramid is cut there.
    float caster = sum / found, dark = 0.0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) dark += depthSeen(i, j, 1.0 - caster / here) < depth ? 1.0 : 0.0;
    }
    fragColor = vec4(dark / float(side * side));
}
