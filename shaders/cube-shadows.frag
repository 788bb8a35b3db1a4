#include "light.glsl"
uniform vec4 color;
uniform bool colored;  // the vertices bring their colours, which are shown as they are
uniform bool lit;
uniform vec4 viewLight;
in vec3 viewPoint;
in vec3 viewNormal;
in vec4 ownColor;
out vec4 fragColor;

void main() {
    if (colored) {
        fragColor = ownColor;
    } else if (lit) {
        fragColor = vec4(shade(color.rgb, viewPoint, normalize(viewNormal), viewLight, 1.0), 1.0);
    } else {
        fragColor = color;
    }
}
