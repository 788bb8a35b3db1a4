// Vertex shader: once for each vertex, or for each control point of a patch. The shader bends the sheet, which costs 16
// points here, however finely the patch is cut afterwards.
#include "vertex.glsl"
uniform mat4 clipFromWorld;
uniform float bend;
in vec3 position;
in vec3 normal;
VERTEX(out);

void main() {
    place = position;
    place.y += bend * (position.x * position.x - position.z * position.z);
    // As the slope of what was added leans it
    facing = normal - 2.0 * bend * normal.y * vec3(position.x, 0.0, -position.z);
    gl_Position = clipFromWorld * vec4(place, 1.0);
}
