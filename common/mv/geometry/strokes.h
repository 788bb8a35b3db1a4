// Lines and filled shapes of the plane as triangles whose rims fade over one pixel: smooth edges without multisampling, and
// lines of any width where glLineWidth draws one pixel, as browsers do.
//
// x and y are pixels; y up or down, as the caller likes. z is the depth that GL gets, -1 .. 1, and follows a line from
// end to end. A rim lies half a pixel to both sides of the edge, so a rectangle with whole coordinates has sharp edges,
// and a line of width 1 is sharp where its middle is half a pixel from a whole number.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// A corner of a triangle. The alpha is what the caller gave, times the part of the pixel that is covered.
struct PaintedVertex {
    vec3 position;
    vec4 color;
};
// Three a triangle, of either winding.
using Painted = std::vector<PaintedVertex>;

// Appends a line of that width in pixels through the points. Corners are mitred up to a turn of 90 degrees, and rounded
// where they turn further. A point equal to the one before it in x and y is passed over; a line of one place has no
// triangles. A width below 1 is drawn 1 wide, and so much fainter. Refused: a width that is not above 0, NaN and
// infinity.
void strokeLine(Painted& painted, std::span<const vec3> points, double width, const vec4& color);

// Appends a convex polygon, in either winding. One that is thinner than a pixel is drawn up to a pixel wide. Fewer than
// three corners, or no area: no triangles. Refused: NaN and infinity.
void fillConvex(Painted& painted, std::span<const vec2> corners, double depth, const vec4& color);

// The corners of a circle, as many as leave no corner to be seen (it is less than a tenth of a pixel off), eight at least.
std::vector<vec2> circle(const vec2& middle, double radius);

// A rectangle of the plane.
struct Box {
    vec2 low, high;
    vec2 size() const { return high - low; }
    bool holds(const vec2& point) const {
        return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
    }
};

// Cuts the triangles from the vertex numbered `first` on to the box; colours and depths at the cuts are those that were
// there.
void cutTo(Painted& painted, std::size_t first, const Box& box);

}  // namespace mv
