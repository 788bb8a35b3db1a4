uniform vec4 color;
uniform bool crop;
uniform float floorHalf;
in vec4 shadow;
out vec4 fragColor;

void main() {
    // |x / w| > floorHalf, without dividing.
    if (crop && max(abs(shadow.x), abs(shadow.z)) > floorHalf * shadow.w) discard;
    fragColor = color;
}
