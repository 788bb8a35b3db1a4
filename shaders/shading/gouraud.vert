// Gouraud shading: each vertex is asked what light it reflects.
#include "reflection.glsl"
uniform mat4 clipFromBody, worldFromBody;
uniform mat3 worldFromNormal;
in vec3 position;
in vec3 normal;
out vec4 light;
out vec3 point;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    point = vec3(worldFromBody * vec4(position, 1.0));
    light = reflected(point, worldFromNormal * normal);
}
