// Rings about two places, as on water. The fragment shader and the compute shaders of gpu-stages all ask for them.
const vec2 firstMiddle = vec2(0.3, 0.35), secondMiddle = vec2(0.7, 0.6);

// The colour of a pixel of a picture of that size.
vec3 ripples(ivec2 pixel, ivec2 size) {
    vec2 at = (vec2(pixel) + 0.5) / float(size.y);
    float wave = sin(40.0 * distance(at, firstMiddle)) + sin(50.0 * distance(at, secondMiddle));
    return mix(vec3(0.10, 0.30, 0.45), vec3(0.90, 0.95, 0.90), 0.5 + 0.25 * wave);
}

// The slope of sin(f r), where r is the distance from the middle of the rings; 0 there, where it has none.
vec2 slopeRound(vec2 from, float f) {
    float r = length(from);
    return r > 0.0 ? f * cos(f * r) * from / r : vec2(0.0);
}
vec2 slopeOf(vec2 at) { return slopeRound(at - firstMiddle, 40.0) + slopeRound(at - secondMiddle, 50.0); }
