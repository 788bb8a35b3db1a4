// The colour of a pixel of a picture of that size: rings about two places, as on water. The fragment shader and the compute
// shader of gpu-stages both ask it.
vec3 ripples(ivec2 pixel, ivec2 size) {
    vec2 at = (vec2(pixel) + 0.5) / float(size.y);
    float wave = sin(40.0 * distance(at, vec2(0.3, 0.35))) + sin(50.0 * distance(at, vec2(0.7, 0.6)));
    return mix(vec3(0.10, 0.30, 0.45), vec3(0.90, 0.95, 0.90), 0.5 + 0.25 * wave);
}
