// The exact intersection of two polygons, concave or not, touching, with common edges, or equal.
#pragma once
#include <cstdint>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// A corner in whole numbers, at most 2^16 in size.
struct GridPoint {
    std::int64_t x = 0, y = 0;
    bool operator==(const GridPoint&) const = default;
};
using GridPolygon = std::vector<GridPoint>;  // its last corner is joined to its first

// Twice its area, positive where the corners go round counter-clockwise.
std::int64_t doubleArea(const GridPolygon& polygon);
// Whether the polygon has an area, and its edges meet only at common corners.
bool isSimple(const GridPolygon& polygon);

// A part of an edge of one of the two polygons, between places where it meets the other. overlap() chooses among these parts.
struct EdgePart {
    vec2 from, to;  // in units of the grid
    enum class Lies { inside, outside, alongSame, alongOpposite } lies = Lies::outside;
    bool ofSecond = false;
    bool kept = false;
};

struct Overlap {
    std::vector<EdgePart> parts;
    // The common area: polygons without holes, counter-clockwise, with corners in units of the grid. Polygons that share only points
    // or edges have no common area.
    std::vector<std::vector<vec2>> polygons;
};

// Cuts each edge where it meets the other polygon, keeps of both what lies inside the other (of what lies along the other, one
// of two that go the same way), and joins what is kept. Places are fractions of whole numbers: so two are the same, or one lies
// along the other, or it does not, and nothing has to be decided by a tolerance. Refused: a polygon that is not simple.
// Source: Margalit and Knott, "An algorithm for computing the union, intersection or difference of two polygons" (1989).
Overlap overlap(GridPolygon first, GridPolygon second);

}  // namespace mv
