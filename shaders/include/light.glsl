// How a surface is lit in all shadow demos: a share of ambient light, and diffuse light by Lambert's cosine. No falloff
// with distance, no highlights, no gamma: colours are linear, so that what a shadow takes away can be measured.
// Points, normals and lights in one space, whichever it is; the normal has unit length and points out of the surface.

const float ambientShare = 0.3;

// The unit vector towards the light: (x, y, z, 1) is a point, (x, y, z, 0) the direction towards a light at infinity.
vec3 towardsLight(vec3 point, vec4 light) { return normalize(light.xyz - light.w * point); }

// Lambert's cosine, 0..1: 0 for a surface that faces away.
float diffuse(vec3 point, vec3 normal, vec4 light) { return max(dot(normal, towardsLight(point, light)), 0.0); }

// The colour of a surface under one light of which the part `lit`, 0 in shadow to 1, gets through.
vec3 shade(vec3 color, vec3 point, vec3 normal, vec4 light, float lit) {
    return color * (ambientShare + (1.0 - ambientShare) * lit * diffuse(point, normal, light));
}

// In a fragment shader: whether the front of the triangle it belongs to faces the light. Decided by the triangle's own
// normal, not the smooth one that shades it.
bool facesLight(vec3 point, vec4 light) {
    vec3 normal = cross(dFdx(point), dFdy(point));  // towards the eye
    bool seenSide = dot(normal, towardsLight(point, light)) > 0.0;
    return gl_FrontFacing ? seenSide : !seenSide;  // asked, not compared: Mesa's softpipe has another number for its truth
}
