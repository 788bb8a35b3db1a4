// sRGB's curve, as in mv/math/color.h.
vec3 srgbFromLinear(vec3 light) {
    vec3 curved = 1.055 * pow(max(light, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    return mix(curved, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

vec3 linearFromSrgb(vec3 kept) {
    vec3 curved = pow((max(kept, 0.04045) + 0.055) / 1.055, vec3(2.4));
    return mix(curved, kept / 12.92, lessThanEqual(kept, vec3(0.04045)));
}
