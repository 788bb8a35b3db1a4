// The texture's colour at the coordinates that a method has found; for a study, how far away they belong.
#include "measure.glsl"
uniform sampler2D image;
uniform float beyond;                         // how many times the texture u and v reach beyond 0..1, both ways together
uniform bool compared;                        // the square alone is
uniform mat3 pixelFromQuad, quadFromPixel;    // up to a factor

void showTexel(vec2 uv) {
    float slip = 0.0;
    bool counts = false;
    if (measuring && compared) {
        vec3 belongs = pixelFromQuad * vec3(uv, 1.0), here = quadFromPixel * vec3(gl_FragCoord.xy, 1.0);
        slip = distance(belongs.xy / belongs.z, gl_FragCoord.xy);
        vec2 inside = 0.499 - abs(here.xy / here.z - 0.5);  // rounding decides at the very edge
        counts = min(inside.x, inside.y) > 0.0;
    }
    show(texture(image, uv + beyond * (uv - 0.5)).rgb, slip, counts);
}
