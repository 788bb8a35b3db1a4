// Bump mapping (Blinn 1978): the slope at each pixel by differences of the height map, and the normal from the slope.
#include "bumped.glsl"
#include "repeats.glsl"
uniform float depth;

void main() {
    mat3 frame = bodyFromFrame();
    vec2 texel = 1.0 / vec2(textureSize(painted, 0));
    vec2 rise = vec2(texture(painted, place + vec2(texel.x, 0.0)).a - texture(painted, place - vec2(texel.x, 0.0)).a,
                     texture(painted, place + vec2(0.0, texel.y)).a - texture(painted, place - vec2(0.0, texel.y)).a);
    vec2 slope = depth * rise / (2.0 * texel * unitsHere(frame[2]));
    showLit(texture(painted, place).rgb, frame * normalize(vec3(-slope, 1.0)));
}
