// Geometry shader: a triangle comes with its neighbours. Corners 0, 2, 4 are its own; 1, 3, 5 are the far corners of the triangles
// beyond its sides. It draws the silhouette's edges out to infinity.
layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 12) out;
uniform mat4 clipFromObject;
uniform vec4 light;  // in the solid's space, homogeneous
in vec3 place[];
flat in int number[];

// Whether the front of triangle i, j, k is turned towards the light. Its neighbours ask this, too, and must get its own answer even
// where rounding decides, or the volume has a hole: so the corner with the least number comes first, whoever asks.
bool faces(int i, int j, int k) {
    int first = number[i] < number[j] ? (number[i] < number[k] ? i : k) : (number[j] < number[k] ? j : k);
    int second = first == i ? j : first == j ? k : i, third = i + j + k - first - second;
    vec3 a = place[first], b = place[second] - a, c = place[third] - a;
    return dot(cross(b, c), light.xyz - light.w * a) > 0.0;
}

void emit(vec4 clip) {
    gl_Position = clip;
    EmitVertex();
}
// The point where the light throws a corner: away from it, to infinity.
vec4 thrown(int i) { return clipFromObject * vec4(light.w * place[i] - light.xyz, 0.0); }

void drawOut(int a, int b) {
    emit(gl_in[b].gl_Position);
    emit(gl_in[a].gl_Position);
    emit(thrown(b));
    emit(thrown(a));
    EndPrimitive();
}

void main() {
    if (!faces(0, 2, 4)) return;
    // A side belongs to the silhouette if the triangle beyond it does not face the light: draw it out
    if (!faces(2, 0, 1)) drawOut(0, 2);
    if (!faces(4, 2, 3)) drawOut(2, 4);
    if (!faces(0, 4, 5)) drawOut(4, 0);
}
