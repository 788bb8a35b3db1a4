// The stored textures in three quarters of the picture, and in the lower right one the light.
#include "srgb.glsl"
#include "stored_surface.glsl"
uniform sampler2D sums;
uniform vec3 background;
out vec4 fragColor;

void main() {
    ivec2 size = textureSize(depths, 0), quarter = (size + 1) / 2, pixel = ivec2(gl_FragCoord.xy), at = pixel % quarter * 2;
    bool isRight = pixel.x >= quarter.x, isUpper = pixel.y >= quarter.y;
    Surface surface = surfaceAt(min(at, size - 1));
    vec4 sum = texelFetch(sums, min(at, size - 1), 0);
    float luminance = dot(sum.rgb, vec3(0.2126, 0.7152, 0.0722));
    vec3 light = srgbFromLinear(sum.rgb / (1.0 + luminance));
    vec3 upper = isRight ? 0.5 + 0.5 * surface.normal : srgbFromLinear(surface.color);
    vec3 lower = isRight ? light : vec3(pow(texelFetch(depths, min(at, size - 1), 0).r, 12.0));
    fragColor = vec4(surface.isThere ? (isUpper ? upper : lower) : background, 1.0);
}
