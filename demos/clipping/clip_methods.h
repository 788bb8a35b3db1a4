// Segments against a window by the textbooks' methods, which are the same on paper and not in double precision; and exactly.
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mv/geometry/clip_segment.h"

namespace mv {

// The regions beyond the sides of the window, as bits of a code in the lecture's order, TBRL.
enum Side : unsigned { leftOf = 1, rightOf = 2, below = 4, above = 8 };
unsigned regionCode(const Box& window, const vec2& point);
// "TBRL" with digits: "0101".
std::string codeText(unsigned code);

// One round of Cohen and Sutherland's method: the segment as it is, the codes of its ends, and what they lead to.
struct CodeRound {
    enum class Does { accept, reject, cut };
    Segment segment;
    unsigned codeA = 0, codeB = 0;
    Does does = Does::cut;
    Side side = leftOf;  // at which the segment is cut
    bool cutsA = false;  // which end is cut off
};
// All rounds. If the last one accepts, its segment is the result.
std::vector<CodeRound> cohenSutherland(const Segment& segment, const Box& window);

// Clip by the parameters t along the segment at which it enters and leaves. Source: Liang and Barsky (1984).
std::optional<Segment> liangBarsky(const Segment& segment, const Box& window);

// A half plane, dot(normal, p) + distance >= 0; the distance of a point is signed, in lengths of the normal.
struct HalfPlane {
    vec2 normal;
    double distance = 0;
    double of(const vec2& point) const { return normal.x * point.x + normal.y * point.y + distance; }
};
std::array<HalfPlane, 4> halfPlanes(const Box& window);
// The half planes of a polygon's edges, in either orientation. The inside of a convex polygon is positive.
std::vector<HalfPlane> halfPlanes(const std::vector<vec2>& polygon);
bool isConvex(const std::vector<vec2>& polygon);
// The area, for corners in either orientation. A part that the outline goes round twice counts twice.
double areaOf(const std::vector<vec2>& polygon);
// Clip, as liangBarsky does, against the half planes of any convex polygon. Source: Cyrus and Beck (1978).
std::optional<Segment> cyrusBeck(const Segment& segment, std::span<const HalfPlane> inside);

// Coordinates as whole numbers of 2^-bits, with at most 53 bits, so that no coordinate is rounded.
struct ExactPart {
    bool meets = false;
    std::array<long double, 4> ends{};  // a.x, a.y, b.x, b.y of what is left, rounded once to long double
};
// Liang and Barsky's method with fractions of whole numbers. Error: a coordinate that is no such number.
ExactPart clipExactly(const Segment& segment, const Box& window, int bits);

// The window with its corners on the grid of whole numbers of 2^-bits, with bits from exactBits(). The corners move by at most
// 16 roundings of the coordinates.
Box exactWindow(const Box& window);
int exactBits(const Box& window);

// Segments from outside an exactWindow() past one of its corners, as near to the corner as doubles allow. Their coordinates are
// such whole numbers, too.
std::vector<Segment> aimedAtCorners(const Box& window, int count);

// The result of a method on such segments: the part that it keeps or rejects wrongly, and the largest error of an end of the
// others, in units in the last place of the segment's and the window's largest coordinate.
struct Trial {
    double wrongPercent = 0, ulps = 0;
};
using ClipMethod = std::function<std::optional<Segment>(const Segment&, const Box&)>;
Trial tryMethod(const ClipMethod& method, const std::vector<Segment>& segments, const Box& window);

}  // namespace mv
