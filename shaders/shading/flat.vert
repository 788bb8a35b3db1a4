// Flat shading: of a face one vertex is asked, and all of it has that light.
#include "reflection.glsl"
uniform mat4 clipFromBody, worldFromBody;
uniform mat3 worldFromNormal;
in vec3 position;
in vec3 normal;
flat out vec4 light;
out vec3 point;

void main() {
    gl_Position = clipFromBody * vec4(position, 1.0);
    point = vec3(worldFromBody * vec4(position, 1.0));
    light = reflected(point, worldFromNormal * normal);
}
