uniform vec4 paint;
uniform bool isBox;
uniform vec3 sun;  // towards it, in view space; 0 where nothing is lit
in vec3 viewPoint;
out vec4 fragColor;

void main() {
    vec3 normal = normalize(cross(dFdx(viewPoint), dFdy(viewPoint)));  // of this face
    fragColor = isBox && sun != vec3(0.0) ? vec4((0.68 + 0.32 * dot(normal, sun)) * paint.rgb, 1.0) : paint;
}
