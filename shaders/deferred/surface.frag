// Several targets: one fragment writes what its surface is, and asks no lamp.
in vec3 worldNormal;
in vec3 ownColor;
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 normal;

void main() {
    color = vec4(ownColor, 1.0);
    normal = vec4(0.5 + 0.5 * normalize(worldNormal), 1.0);  // -1 .. 1 does not fit a target of 0 .. 1
}
