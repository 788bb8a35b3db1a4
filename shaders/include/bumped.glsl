// The frame in which a normal map is told, and how far its texture goes round.
#include "relief.glsl"
uniform bool keepsSign;  // of mirrored texture coordinates
in vec4 along;

// Columns: along growing u, along growing v, out of the surface.
mat3 bodyFromFrame() {
    vec3 n = normalize(facing), t = normalize(along.xyz - dot(along.xyz, n) * n);
    float mirrored = keepsSign && along.w < 0.0 ? -1.0 : 1.0;
    return mat3(t, mirrored * cross(n, t), n);
}
