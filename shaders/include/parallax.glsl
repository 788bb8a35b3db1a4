// The part common to parallax mapping and its kind: where the line of sight goes below the smooth surface.
#include "bumped.glsl"
#include "repeats.glsl"
uniform float depth;
uniform sampler2D normals;

// How the place changes from the smooth surface down to the deepest point of the relief. The shift grows without end
// towards grazing sight, so it stays as it is at 87 degrees (flattestSight in demos/shared/relief.h).
vec2 shiftDown(mat3 frame) {
    vec3 sight = view * frame;
    return -depth / max(sight.z, 0.05) * sight.xy / unitsHere(frame[2]);
}

void showAt(vec2 found, vec2 across, vec2 up, mat3 frame) {
    vec3 normal = 2.0 * textureGrad(normals, found, across, up).xyz - 1.0;
    showLit(textureGrad(painted, found, across, up).rgb, frame * normalize(normal));
}
