// Fragment shader: asked for each pixel that the square covers, it gives its colour.
#include "ripples.glsl"
uniform vec2 corner, size;
out vec4 fragColor;

void main() { fragColor = vec4(ripples(ivec2(gl_FragCoord.xy - corner), ivec2(size)), 1.0); }
