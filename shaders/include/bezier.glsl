// Tessellation evaluation shader: once for each point (u, v) that the tessellator has made. The shader says where that
// is: on the bicubic Bezier surface of the 16 control points.
uniform mat4 clipFromWorld;
in Vertex {
    vec3 place, facing;
}
from[];
out Vertex {
    vec3 place, facing;
};

// The four polynomials of Bernstein, and their derivatives.
vec4 bernstein(float t) {
    float s = 1.0 - t;
    return vec4(s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t);
}
vec4 slopes(float t) {
    float s = 1.0 - t;
    return vec4(-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t);
}

vec3 weighted(vec4 alongU, vec4 alongV) {
    vec3 sum = vec3(0.0);
    for (int row = 0; row < 4; ++row) {
        for (int i = 0; i < 4; ++i) sum += alongU[i] * alongV[row] * from[4 * row + i].place;
    }
    return sum;
}

void main() {
    vec4 u = bernstein(gl_TessCoord.x), v = bernstein(gl_TessCoord.y);
    place = weighted(u, v);
    facing = cross(weighted(slopes(gl_TessCoord.x), v), weighted(u, slopes(gl_TessCoord.y)));
    gl_Position = clipFromWorld * vec4(place, 1.0);
}
