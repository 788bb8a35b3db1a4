// A room with balls, as a ray sees it from inside. The same in double precision: demos/shared/surroundings.cpp.

uniform float room;  // half of its width and depth
uniform vec3 ballAt[4], ballColor[4];

const vec3 proportions = vec3(1.0, 0.6, 1.0);
const float ballPart = 0.13;  // of the room's size, the balls' radius

// -1..1, with soft edges between tiles of 0.2.
float tiles(vec2 at) {
    vec2 waves = sin(15.70796327 * at);
    float wave = waves.x * waves.y;
    return wave * inversesqrt(wave * wave + 0.1);
}

// At a point of a wall of the room of size 1.
vec3 wallColor(vec3 point) {
    vec3 near = abs(point) / proportions;
    if (near.y >= near.x && near.y >= near.z) {
        float tile = tiles(point.xz);
        if (point.y < 0.0) return vec3(0.55, 0.50, 0.45) * (0.75 + 0.25 * tile);
        float lamp = 1.0 - smoothstep(0.28, 0.34, max(abs(point.x), abs(point.z)));
        return mix(vec3(0.72, 0.72, 0.70) * (0.92 + 0.08 * tile), vec3(1.0, 1.0, 0.94), lamp);
    }
    if (near.x >= near.z) {
        vec3 color = point.x < 0.0 ? vec3(0.72, 0.36, 0.30) : vec3(0.36, 0.55, 0.40);
        return color * (0.8 + 0.2 * tiles(point.zy));
    }
    vec3 color = point.z < 0.0 ? vec3(0.42, 0.52, 0.68) : vec3(0.80, 0.70, 0.45);
    return color * (0.8 + 0.2 * tiles(point.xy));
}

vec3 ballLight(vec3 color, vec3 normal) { return color * (0.6 + 0.4 * normal.y); }

// Where a ray that starts inside meets a wall. A component 0 of its way never does: 1e-30 takes longer than the others.
vec3 wallAlong(vec3 from, vec3 way) {
    vec3 walls = room * proportions, moves = mix(way, vec3(1e-30), equal(way, vec3(0.0)));
    vec3 lengths = (mix(walls, -walls, lessThan(moves, vec3(0.0))) - from) / moves;
    return from + min(lengths.x, min(lengths.y, lengths.z)) * way;
}

// The light that comes along a ray of unit direction.
vec3 seenAlong(vec3 from, vec3 way) {
    vec3 light = wallColor(wallAlong(from, way) / room);
    float nearest = 1e30, radius = ballPart * room;
    for (int i = 0; i < 4; ++i) {
        vec3 to = from - ballAt[i];
        // How far from the middle the ray passes: a cross product, which has no difference of large squares.
        vec3 miss = cross(to, way);
        float square = radius * radius - dot(miss, miss);
        if (square < 0.0) continue;
        float t = -dot(to, way) - sqrt(square);
        if (t < 0.0 || t > nearest) continue;
        nearest = t;
        light = ballLight(ballColor[i], (to + t * way) / radius);
    }
    return light;
}
