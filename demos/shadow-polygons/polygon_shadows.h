// The shadows of flat polygons on flat polygons, as polygons: each caster is projected from the light onto a receiver's plane and
// clipped there. Which pairs are projected is found on a sphere round the light.
#pragma once
#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// Convex and flat, with an area; its corners go round in either sense, in world space. Both sides are surfaces.
struct FlatPolygon {
    std::vector<vec3> corners;
    vec3 color{0.8, 0.8, 0.8};
    bool operator==(const FlatPolygon&) const = default;
};

// What is computed once of a polygon on which shadows fall. Its space has its origin at a corner of the polygon, and the axes of
// world space: there the plane goes through the origin, wherever it is in the world.
struct Receiver {
    vec3 origin{0, 0, 0};
    vec3 normal{0, 0, 0};          // of unit length, on the light's side
    mat4 shadowFromCaster{1};      // the projection onto the plane, to be divided by w
    std::array<vec4, 2> bounds{};  // where what casts has to be: before the plane, and lower than the light
    std::vector<vec4> edges;       // half spaces across the plane that hold the polygon
    double area = 0;
    double size = 0;  // of its largest coordinate in the world
};
// Nothing where the light lies in the polygon's plane, as far as lightSide() can tell, so that neither side is lit.
// Error: a polygon without area, or not finite; a light that is not finite.
std::optional<Receiver> receiverOf(const FlatPolygon& polygon, const vec3& light);

// The dark part of the receiver behind the caster: a convex polygon in world space, which goes round counter-clockwise as the
// light sees it; empty where there is none. What of the caster lies behind the receiver's plane, in it, or beyond the light throws
// no shadow there and is cut off first. A part below 1e-14 of the receiver's area is left out: neighbours that only touch make
// such, by rounding.
std::vector<vec3> shadowOn(const Receiver& receiver, const FlatPolygon& caster);

// Where a polygon is on the sphere round the light: its projection lies in a ball about a point of the sphere. Distances from the
// light are those of the polygon.
struct Cap {
    vec3 axis{0, 1, 0};  // the middle's direction from the light, of unit length
    double chord = 2;    // the ball's radius, in radii of the sphere; 2 holds all of the sphere
    double nearest = 0, farthest = 0;
};
// A polygon that takes up half of the sphere or more, or holds the light, gets all of it.
Cap capOf(const FlatPolygon& polygon, const vec3& light);
// Whether two caps have a point in common: of two whose polygons' projections overlap always, of others sometimes.
bool mayOverlap(const Cap& a, const Cap& b);
// Whether a point of the one may be nearer to the light than a point of the other.
bool mayHide(const Cap& caster, const Cap& receiver);

struct CasterOn {
    std::size_t receiver, caster;
    auto operator<=>(const CasterOn&) const = default;
};
struct Pairs {
    std::vector<CasterOn> kept;  // to be projected: by receivers, and of one by casters
    long tested = 0;             // pairs of caps that were compared
};
// Each polygon on each other one: count (count - 1) pairs, without a test.
Pairs allPairs(std::size_t count);
// The pairs whose caps overlap, with a caster that may be nearer than the receiver. Compared are only caps that overlap in x.
// Source: Bouknight and Kelley, "An algorithm for producing half-tone computer graphics presentations with shadows and movable
// light sources" (1970).
Pairs pairsOnSphere(const std::vector<Cap>& caps);

}  // namespace mv
