// A lookup along a pixel's footprint that costs no more than the looks allow, as a GPU does it. At the horizon, where a pixel covers
// thousands of repeats of the texture, an implementation that walks all of the footprint would walk for seconds.

// How far the place moves across a pixel: 0 where that is no number, and no longer than so many repeats, beyond which the same
// texels come once more.
vec2 boundedStep(vec2 across, float repeats) {
    float longest = max(abs(across.x), abs(across.y));
    if (!(longest < 1e30)) return vec2(0.0);
    return longest > repeats ? across * (repeats / longest) : across;
}

// The shorter one, widened until the longer one is no more than `looks` times as long.
vec2 widened(vec2 shorter, vec2 longer, float looks) {
    float least = length(longer) / looks, present = length(shorter);
    if (present >= least) return shorter;
    return present > 0.0 ? shorter * (least / present) : least * normalize(vec2(-longer.y, longer.x));
}

// Both steps of a footprint: neither longer than `looks` repeats, nor `looks` times as long as the other.
void boundFootprint(inout vec2 x, inout vec2 y, float looks) {
    x = boundedStep(x, looks);
    y = boundedStep(y, looks);
    if (length(x) < length(y)) {
        x = widened(x, y, looks);
    } else if (length(y) < length(x)) {
        y = widened(y, x, looks);
    }
}

// Up to `looks` looks along the footprint, of which there are two or more.
vec4 lookedUpAlong(sampler2D image, vec2 place, int looks, float bias) {
    vec2 x = exp2(bias) * dFdx(place), y = exp2(bias) * dFdy(place);
    boundFootprint(x, y, float(looks));
    // Beyond, numbers are too far apart to go from texel to texel.
    if (!(max(abs(place.x), abs(place.y)) < 4096.0)) place = fract(place);
    return textureGrad(image, place, x, y);
}
