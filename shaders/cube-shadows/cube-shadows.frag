#include "light.glsl"
uniform vec4 viewLight;
in vec3 viewPoint;
in vec3 viewNormal;
in vec4 ownColor;
out vec4 fragColor;

void main() {
    fragColor = ownColor;
    // A mesh without normals has (0, 0, 0) here, and is shown as it is.
    if (dot(viewNormal, viewNormal) > 0.0) {
        fragColor.rgb = shade(ownColor.rgb, viewPoint, normalize(viewNormal), viewLight, 1.0);
    }
}
