// How finely a patch is cut. demos/displacement/relief_patches.h has the same rule in C++.
#include "tessellation.glsl"
layout(vertices = 4) out;
uniform mat4 clipFromBody;
uniform vec3 eye;  // in the body's space
uniform float depth, fixedLevel, fineness;
uniform bool isRound, byDistance, agrees, leavesOut;
in vec3 corner[];
out vec3 control[];

// Whether all of the patch lies outside of one plane of the view, wherever its points are moved. A body with flat faces holds
// it: of the wall a box, of the orange a part of the pyramid from its middle through the corners.
bool isOutsideView() {
    vec3 middle = isRound ? normalize(corner[0] + corner[1] + corner[2] + corner[3]) : vec3(0.0, 0.0, 1.0);
    float least = 1.0;
    for (int i = 0; i < 4; ++i) least = min(least, dot(corner[i], middle));
    ivec3 beyond = ivec3(0), before = ivec3(0);
    for (int i = 0; i < 4; ++i) {
        vec3 top = isRound ? corner[i] / dot(corner[i], middle) : corner[i];
        vec3 bottom = isRound ? (1.0 - depth) * least * top : top - depth * middle;
        vec4 ends[2] = vec4[2](clipFromBody * vec4(top, 1.0), clipFromBody * vec4(bottom, 1.0));
        for (int k = 0; k < 2; ++k) {
            beyond += ivec3(greaterThan(ends[k].xyz, ends[k].www));
            before += ivec3(lessThan(ends[k].xyz, -ends[k].www));
        }
    }
    return any(equal(beyond, ivec3(8))) || any(equal(before, ivec3(8)));
}

// The level of the edge between two corners. The level is that of a line across the patch where patches do not agree.
float levelOf(int a, int b) {
    if (!byDistance) return levelInRange(fixedLevel);
    if (agrees) return edgeLevel(corner[a], corner[b], eye, fineness);
    return edgeLevel(0.5 * (corner[0] + corner[2]), 0.5 * (corner[1] + corner[3]), eye, fineness);
}

void main() {
    control[gl_InvocationID] = corner[gl_InvocationID];
    if (gl_InvocationID > 0) return;
    vec4 outer = vec4(0.0);  // which leaves the patch out
    if (!(leavesOut && isOutsideView())) outer = vec4(levelOf(0, 2), levelOf(0, 1), levelOf(1, 3), levelOf(2, 3));
    float inner = max(max(outer.x, outer.y), max(outer.z, outer.w));
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = outer[i];
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inner;
}
