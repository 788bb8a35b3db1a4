// Which part of the light a smooth surface reflects, for unpolarized light. The same in double precision:
// demos/shared/fresnel.cpp.

uniform int material;    // 0 mirror, 1 metal, 2 glass
uniform float index;     // of the glass, over that of what is around it
uniform vec3 metalIndex; // of the metal, for red, green and blue
uniform vec3 metalAbsorption;

// ratio^2 cos^2 of the angle behind a surface with this ratio of indices; not above 0 where all is reflected.
float squareBehind(float cosine, float ratio) { return (ratio - 1.0) * (ratio + 1.0) + cosine * cosine; }

// The direction behind the surface of light that travels along `way`, where there is one. Unlike refract() it has no 0
// vector for an answer.
vec3 refracted(vec3 way, vec3 normal, float ratio) {
    float cosine = -dot(way, normal);
    return way / ratio + normal * ((cosine - sqrt(max(squareBehind(cosine, ratio), 0.0))) / ratio);
}

// Whether there is light behind the surface.
float fresnelOfGlass(float cosine) {
    if (index == 1.0) return 0.0;  // no surface
    float behind = sqrt(squareBehind(cosine, index)), dense = index * index * cosine;
    float across = (cosine - behind) / (cosine + behind), along = (dense - behind) / (dense + behind);
    return 0.5 * (across * across + along * along);
}

vec3 fresnelOfMetal(float cosine) {
    float c2 = cosine * cosine, s2 = 1.0 - c2;
    vec3 real = metalIndex * metalIndex - metalAbsorption * metalAbsorption - s2;
    vec3 imaginary = 2.0 * metalIndex * metalAbsorption;
    vec3 both = sqrt(real * real + imaginary * imaginary);
    vec3 middle = 2.0 * cosine * sqrt(max(0.5 * (both + real), 0.0));  // rounding may leave a little less than 0
    vec3 across = (both - middle + c2) / (both + middle + c2);
    vec3 along = across * (c2 * both - s2 * middle + s2 * s2) / (c2 * both + s2 * middle + s2 * s2);
    return 0.5 * (across + along);
}

vec3 fresnel(float cosine, bool bySchlick) {
    if (material == 0) return vec3(1.0);
    // Total reflection, of which Schlick's curve does not know. An index of 1 is none, at any angle.
    if (material == 2 && index != 1.0 && squareBehind(cosine, index) <= 0.0) return vec3(1.0);
    vec3 headOn = material == 1 ? fresnelOfMetal(1.0) : vec3(fresnelOfGlass(1.0));
    if (bySchlick) return headOn + (1.0 - headOn) * pow(1.0 - cosine, 5.0);
    return material == 1 ? fresnelOfMetal(cosine) : vec3(fresnelOfGlass(cosine));
}
