// It hands on where the vertex is in the solid's own space, and which one it is: sides.geom asks.
uniform mat4 clipFromObject;
in vec4 position;
out vec3 place;
flat out int number;

invariant gl_Position;  // as in shadow-volume.vert

void main() {
    gl_Position = clipFromObject * position;
    place = position.xyz;
    number = gl_VertexID;
}
