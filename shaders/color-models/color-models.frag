// A place of a solid is a colour: the height is its lightness, the angle its hue.
uniform mat3 rgbFromModel;
uniform vec3 cuts;
uniform int model;
in vec3 place;
in float onCut;
out vec4 fragColor;

vec3 rgbFromHsl(float hue, float saturation, float lightness) {
    vec3 k = mod(vec3(0.0, 8.0, 4.0) + hue / 30.0, 12.0);
    vec3 wave = max(vec3(-1.0), min(min(k - 3.0, 9.0 - k), vec3(1.0)));
    return lightness - saturation * min(lightness, 1.0 - lightness) * wave;
}

vec3 rgbFromHsv(float hue, float saturation, float value) {
    vec3 k = mod(vec3(5.0, 3.0, 1.0) + hue / 60.0, 6.0);
    return value - value * saturation * clamp(min(k, 4.0 - k), 0.0, 1.0);
}

void main() {
    float radius = 2.0 * length(place.xz);  // 1 at the rim
    float hue = radius > 1e-6 ? degrees(atan(-place.z, place.x)) : 0.0;
    float widest = model == 1 ? 1.0 - abs(2.0 * place.y - 1.0) : place.y;
    vec3 rgb = rgbFromModel * place;
    bool inside = model == 0 ? all(lessThan(abs(rgb - 0.5), vec3(0.5001))) : place.y <= 1.0 && radius < widest + 0.0001;
    if (onCut > 0.5 ? !inside : place.y > cuts[model]) discard;

    float saturation = min(radius / max(widest, 1e-6), 1.0);
    if (model == 1) rgb = rgbFromHsl(hue, saturation, place.y);
    if (model == 2) rgb = rgbFromHsv(hue, saturation, place.y);
    fragColor = vec4(rgb, 1.0);
}
