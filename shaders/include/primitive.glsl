// The input of a geometry shader: all corners of a primitive.
uniform mat4 clipFromWorld;
in Vertex {
    vec3 place, facing;
}
from[];
out Vertex {
    vec3 place, facing;
};

void emit(vec3 at, vec3 normal) {
    place = at;
    facing = normal;
    gl_Position = clipFromWorld * vec4(at, 1.0);
    EmitVertex();
}
