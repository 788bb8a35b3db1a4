// The texels of one level as squares; where they are smaller than pixels, the mean of some of them.
#include "srgb.glsl"
uniform sampler2D image;
uniform int level;
uniform vec2 pixel;    // its size, in repeats
uniform bool encoded;  // as in texture-filter.frag
in vec2 place;
out vec4 fragColor;

void main() {
    vec2 size = vec2(textureSize(image, level));
    int points = int(clamp(ceil(pixel.y * size.y), 1.0, 8.0));  // along each side of the pixel
    vec3 sum = vec3(0.0);
    for (int j = 0; j < points; ++j) {
        for (int i = 0; i < points; ++i) {
            vec2 moved = (vec2(i, j) + 0.5) / float(points) - 0.5;
            vec2 at = fract(place + moved * pixel) * size;
            sum += texelFetch(image, ivec2(min(at, size - 1.0)), level).rgb;
        }
    }
    vec3 mean = sum / float(points * points);
    fragColor = vec4(encoded ? mean : srgbFromLinear(mean), 1.0);
}
