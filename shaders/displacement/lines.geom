// Each corner of a triangle is told how far it is from the edge opposite it, in pixels. Interpolated over the triangle these
// are the distances from its edges, by which lines are drawn without polygon mode.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
uniform vec2 halfPicture;
in vec3 point[], facing[];
in vec2 place[];
in float level[];
out vec3 onPoint, onFacing;
out vec2 onPlace;
out float onLevel;
noperspective out vec3 fromEdges;

void main() {
    bool isBefore = gl_in[0].gl_Position.w > 0.0 && gl_in[1].gl_Position.w > 0.0 && gl_in[2].gl_Position.w > 0.0;
    vec2 at[3];
    for (int i = 0; i < 3; ++i) at[i] = halfPicture * gl_in[i].gl_Position.xy / gl_in[i].gl_Position.w;
    vec2 a = at[1] - at[0], b = at[2] - at[0];
    float area = abs(a.x * b.y - a.y * b.x);
    for (int i = 0; i < 3; ++i) {
        onPoint = point[i];
        onFacing = facing[i];
        onPlace = place[i];
        onLevel = level[i];
        fromEdges = vec3(isBefore ? 0.0 : 1e3);  // no lines where a corner is behind the eye
        if (isBefore) fromEdges[i] = area / max(distance(at[(i + 1) % 3], at[(i + 2) % 3]), 1e-6);
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
