// Segments and points of a plane against a window: decided as if there were no rounding.
#pragma once
#include <optional>

#include "mv/geometry/strokes.h"
#include "mv/math/types.h"

namespace mv {

struct Segment {
    vec2 a, b;
    bool operator==(const Segment&) const = default;
};

// 1 where a, b, c turn to the left, -1 where they turn to the right, 0 where they are on one line: exactly so, for
// coordinates that are 0 or from 1e-100 to 1e100 in size. From the rounded cross product the sign is a matter of luck where
// c is as near to the line as its coordinates are fine.
// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997).
int orientation(const vec2& a, const vec2& b, const vec2& c);

// The part of the segment in the window, its edges with it, in the segment's direction; none where they do not meet. Whether
// they do is decided exactly, and a new end lies on an edge of the window, off the true place by at most 4 ulp of the largest
// coordinate. Walked the other way, the segment is cut at the same bits. Coordinates as for orientation(). Refused: NaN and
// infinity, and a window whose low corner is not below and left of its high one, or the same.
std::optional<Segment> clipSegment(const Segment& segment, const Box& window);

}  // namespace mv
