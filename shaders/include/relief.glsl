// How a bumped surface is lit, in the space of its body: as reliefLight() in demos/shared/relief.h.
#include "measure.glsl"
#include "srgb.glsl"
uniform vec3 light, view;  // unit vectors, to the lamp and to the eye, both at infinity
uniform vec2 band;         // a study asks for points whose distance from the line of sight through the body's middle is within
uniform sampler2D painted; // colour, and in alpha the height
in vec3 point;
in vec3 facing;            // the smooth surface's normal
in vec2 place;

// The light that is sent to the eye, as linear light.
vec3 litRelief(vec3 color, vec3 normal) {
    float cosine = max(dot(normal, light), 0.0);
    vec3 both = light + view;
    float towards = cosine > 0.0 && dot(both, both) > 0.0 ? max(dot(normal, normalize(both)), 0.0) : 0.0;
    return (0.2 + 0.8 * cosine) * color + (towards > 0.0 ? 0.15 * pow(towards, 40.0) : 0.0);
}

void showLit(vec3 color, vec3 normal) {
    vec3 lit = litRelief(color, normal);
    float away = length(cross(view, point));
    show(srgbFromLinear(lit), dot(lit, vec3(0.2126, 0.7152, 0.0722)), away >= band.x && away <= band.y);
}
