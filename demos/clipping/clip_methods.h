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

// What lies beyond a side of the window, as bits of a code: TBRL, the lecture's order.
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
    Side side = leftOf;  // that it is cut at
    bool cutsA = false;  // which end is cut off
};
// All rounds; what is left of the segment is that of the last one, where it accepts.
std::vector<CodeRound> cohenSutherland(const Segment& segment, const Box& window);

// By the parameter t along the segment, from and to which it is inside. Source: Liang and Barsky (1984).
std::optional<Segment> liangBarsky(const Segment& segment, const Box& window);

// A half plane, dot(normal, p) + distance >= 0; the distance of a point is signed, in lengths of the normal.
struct HalfPlane {
    vec2 normal;
    double distance = 0;
    double of(const vec2& point) const { return normal.x * point.x + normal.y * point.y + distance; }
};
std::array<HalfPlane, 4> halfPlanes(const Box& window);
// Of a polygon's edges, either way round, inside positive where it is convex.
std::vector<HalfPlane> halfPlanes(const std::vector<vec2>& polygon);
bool isConvex(const std::vector<vec2>& polygon);
// Either way round; edges that lie on each other count as often as they do.
double areaOf(const std::vector<vec2>& polygon);
// The same against the half planes of any convex polygon. Source: Cyrus and Beck (1978).
std::optional<Segment> cyrusBeck(const Segment& segment, std::span<const HalfPlane> inside);

// Coordinates as whole numbers of 2^-bits, of at most 53 bits: what is exact here is so without rounding.
struct ExactPart {
    bool meets = false;
    std::array<long double, 4> ends{};  // a.x, a.y, b.x, b.y of what is left, rounded once to long double
};
// Liang and Barsky's method with fractions of whole numbers. Error: a coordinate that is none.
ExactPart clipExactly(const Segment& segment, const Box& window, int bits);

// The window with its corners on the grid of whole numbers of 2^-bits, where bits is what exactBits() says of it: as near as
// 16 roundings of its coordinates.
Box exactWindow(const Box& window);
int exactBits(const Box& window);

// Segments from beyond an exactWindow(), aimed at one of its corners and on as far as behind it: as near to the corner as doubles
// let them. Their coordinates are such whole numbers, too.
std::vector<Segment> aimedAtCorners(const Box& window, int count);

// How a method does on such segments: the part that it keeps or rejects wrongly, and the largest error of an end of those
// decided rightly, in units in the last place of the segment's and the window's largest coordinate.
struct Trial {
    double wrongPercent = 0, ulps = 0;
};
using ClipMethod = std::function<std::optional<Segment>(const Segment&, const Box&)>;
Trial tryMethod(const ClipMethod& method, const std::vector<Segment>& segments, const Box& window);

}  // namespace mv
