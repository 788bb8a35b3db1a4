// The brightest colour of this screen that has the chromaticity; grey where it has none.
#include "srgb.glsl"
uniform mat3 linearFromXyz;
in vec2 xy;
out vec4 fragColor;

void main() {
    vec3 xyz = vec3(xy, 1.0 - xy.x - xy.y);
    vec3 linear = linearFromXyz * xyz;
    float most = max(linear.r, max(linear.g, linear.b));
    bool isShown = min(linear.r, min(linear.g, linear.b)) >= 0.0;
    vec3 x = max(linear / most, 0.0);
    fragColor = vec4(isShown ? srgbFromLinear(x) : vec3(0.8), 1.0);
}
