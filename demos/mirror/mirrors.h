// Plane mirrors: the place of their images, the part of the picture that shows an image, and the objects that no mirror shows.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// A rectangle that mirrors on one side: where `halfU` is to the right and `halfV` up, it faces who looks at it. The two
// halves of its sides are at right angles.
struct Mirror {
    vec3 middle{0}, halfU{1, 0, 0}, halfV{0, 1, 0};
    vec4 plane() const;                   // with a unit normal, which points to the mirroring side
    std::array<vec3, 4> corners() const;  // counter-clockwise seen from there
};

// A mirror that is seen, in the eye's own picture or within other mirrors.
struct SeenMirror {
    std::size_t which;     // of the mirrors
    mat4 worldFromMirror;  // where the mirror appears: the reflections in those that show it, the first on the left
    mat4 worldFromShown;   // where what it shows appears: the same, times the reflection in this one
    // The part of it that is seen: a polygon in clip space, cut to the view and to the mirrors that show it.
    std::vector<vec4> outline;
    // The half spaces of clip space, through the eye and the edges of the outline, between which all lies that it shows.
    std::vector<vec4> edges;
};

// The edges of the eye's own picture: the sides of the view volume, and its near and far plane.
std::vector<vec4> edgesOfView();

// The mirrors that are seen through one another: [0] the first mirror, what is seen in it as [1], and so on, at most `most`.
// Two mirrors at most, so what is seen in one is the other. A chain begins with each mirror that the eye is in front of
// and that is in the view; it ends where the other mirror is not seen. An eye in a mirror's plane, as lightSide() judges
// it, sees nothing in it. Refused: more than two mirrors; a clipFromWorld that has no inverse.
std::vector<std::vector<SeenMirror>> mirrorChains(std::span<const Mirror> mirrors, const mat4& clipFromWorld, int most);

// Whether all of these points are on the outer side of one half space (dot(h, p) < 0), so that nothing of what they span
// is on its inner side.
bool areBeyond(std::span<const vec4> points, std::span<const vec4> halfSpaces);

// A plane of world space, as the space that worldFromOther maps from has it.
vec4 planeIn(const mat4& worldFromOther, const vec4& plane);

// clipFromView with a near plane of any direction: what is behind `plane` (view space, the normal towards what stays) is
// cut off. x, y and w stay as they were, to the bit; the far plane moves, and still lets through what was within the old
// one. Trap: depths are no longer spread as before. The nearer the eye is to the plane, the less there is left of them:
// points on one ray differ by the eye's distance from the plane times the difference of their 1/z. Refused: an eye in
// front of the plane or in it.
// Source: Lengyel, "Oblique View Frustum Depth Projection and Clipping" (2005).
mat4 withNearPlane(const mat4& clipFromView, const vec4& plane);

}  // namespace mv
