// The picture that the compute shader has stored, texel by pixel.
uniform sampler2D image;
uniform vec2 corner;
out vec4 fragColor;

void main() { fragColor = texelFetch(image, ivec2(gl_FragCoord.xy - corner), 0); }
