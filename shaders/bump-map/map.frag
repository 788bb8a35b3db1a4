// A map as a picture: its colours as they are kept, or its alpha as grey.
uniform sampler2D image;
uniform bool isAlpha;
in vec2 place;
out vec4 fragColor;

void main() {
    vec4 texel = texture(image, place);
    fragColor = vec4(isAlpha ? vec3(texel.a) : texel.rgb, 1.0);
}
