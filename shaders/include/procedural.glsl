// Patterns as functions of the surface point, each a number 0..1. The point is centre + offset. The centre's part was
// computed in double precision, for each octave: the cell that it lies in, as two halves of 16 bits, and where in that
// cell. So what floats round is small, however far the centre is from the origin and however small the offsets are.
// The same in double precision: demos/shared/procedural.cpp.

const int mostOctaves = 9;
uniform vec3 cellLow[mostOctaves], cellHigh[mostOctaves];  // of the centre, at the frequency of each octave
uniform vec3 inCell[mostOctaves];                          // -0.5..0.5
uniform vec3 baseLow, baseHigh, inBase;                    // the same at frequency 1; for bricks y counts rows
uniform vec3 octaves[mostOctaves];                         // frequency, weight, and 1 where it is there at all
uniform vec3 ringsAt;    // wood: direction from the axis to the centre, and 1/distance (0: the centre is near the axis)
uniform float ringBase;  // and the rings up to the centre, whole ones left out
uniform vec3 ringCentre; // and the centre itself, read where it is near
uniform int pattern;     // 0 brick, 1 wood, 2 marble, 3 noise

// Three numbers of 32 bits that look random. Source: Jarzynski and Olano, "Hash functions for GPU rendering" (2020), pcg3d.
uvec3 scattered(ivec3 cell) {
    uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}
vec3 gradientAt(ivec3 cell) { return vec3(scattered(cell) >> 8u) * (2.0 / 16777215.0) - 1.0; }

// Gradient noise, -1..1, with continuous second derivatives. Source: Perlin, "Improving noise" (2002).
float noise(ivec3 cell, vec3 p) {
    vec3 corner0 = floor(p), t = p - corner0;
    cell += ivec3(corner0);
    vec3 s = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 near = mix(1.0 - s, s, vec3(corner));
        sum += near.x * near.y * near.z * dot(gradientAt(cell + corner), t - vec3(corner));
    }
    return sum;
}

ivec3 whole(vec3 low, vec3 high) { return ivec3(low) + ivec3(high) * 65536; }

// How much is left of a wave of so many periods a pixel: all below a quarter, nothing from one on.
float leftOf(float periods) { return 1.0 - smoothstep(0.25, 1.0, periods); }

// A sum of octaves; those finer than a pixel of this size are left out. footprint 0: none. A wave of noise is two cells long.
float octaveSum(vec3 offset, float footprint) {
    float sum = 0.0;
    for (int k = 0; k < mostOctaves; ++k) {
        float weight = octaves[k].y * leftOf(0.5 * footprint * octaves[k].x);
        if (octaves[k].z > 0.0 && weight > 0.0) sum += weight * noise(whole(cellLow[k], cellHigh[k]), inCell[k] + offset * octaves[k].x);
    }
    return sum;
}

// The part of [x - w/2, x + w/2] that lies where the fraction is above `mortar`: a mean over a pixel, exactly.
float above(float x, float w, float mortar) {
    if (w == 0.0) return fract(x) >= mortar ? 1.0 : 0.0;
    float a = x - 0.5 * w, b = x + 0.5 * w;
    float upToA = floor(a) * (1.0 - mortar) + max(fract(a) - mortar, 0.0);
    float upToB = floor(b) * (1.0 - mortar) + max(fract(b) - mortar, 0.0);
    return (upToB - upToA) / w;
}

// Bricks 1 x 1/2, every second row shifted by half, in mortar.
float brick(vec3 offset, vec2 size) {
    vec2 p = inBase.xy + vec2(offset.x, 2.0 * offset.y);
    ivec3 cell = whole(baseLow, baseHigh);
    int row = cell.y + int(floor(p.y));
    float x = p.x + ((row & 1) != 0 ? 0.5 : 0.0);
    float shade = float(scattered(ivec3(cell.x + int(floor(x)), row, 0)).x >> 8u) / 16777215.0;
    float known = leftOf(max(size.x, 2.0 * size.y));  // far away the shades are seen as their mean
    float body = 0.55 + 0.45 * mix(0.5, shade, known);
    return body * above(x, size.x, 0.06) * above(p.y, 2.0 * size.y, 0.12);
}

// Rings about the z axis, four to a unit, bent by noise.
float wood(vec3 offset, float footprint) {
    float rings;
    if (ringsAt.z > 0.0) {
        vec2 away = offset.xy * ringsAt.z;
        rings = ringBase + 4.0 * (2.0 * dot(ringsAt.xy, offset.xy) + dot(away, offset.xy)) /
                               (length(ringsAt.xy + away) + 1.0);
    } else {
        rings = 4.0 * length(ringCentre.xy + offset.xy);
    }
    rings += octaveSum(offset, footprint);
    return 0.5 + 0.5 * leftOf(4.0 * footprint) * cos(6.2831853 * fract(rings));
}

// Layers along x, bent by noise.
float marble(vec3 offset, float footprint) {
    float layers = inBase.x + offset.x + 1.5 * octaveSum(offset, footprint);
    return 0.5 + 0.5 * leftOf(footprint) * cos(6.2831853 * fract(layers));
}

float patternAt(vec3 offset, vec3 size) {
    float footprint = max(size.x, max(size.y, size.z));
    if (pattern == 0) return brick(offset, size.xy);
    if (pattern == 1) return wood(offset, footprint);
    if (pattern == 2) return marble(offset, footprint);
    return clamp(0.5 + 0.6 * octaveSum(offset, footprint), 0.0, 1.0);
}
